#include "examples/motorcycle/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace gabarit::motorcycle {

namespace {

double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
double length(Vec2 a) { return std::sqrt(dot(a, a)); }

// How a corner is rounded: where the arc leaves the sides, its centre, where it starts and how far it turns.
struct Rounding {
  Vec2 from = {}, to = {}, centre = {};
  double radius = 0, start = 0, sweep = 0, trim = 0;
};

Rounding rounding(const Corner& before, const Corner& corner, const Corner& after) {
  const Vec2 here{corner.x, corner.y};
  const Vec2 in = here - Vec2{before.x, before.y}, out = Vec2{after.x, after.y} - here;
  const Vec2 d1 = (1 / length(in)) * in, d2 = (1 / length(out)) * out;
  const double turn = std::atan2(cross(d1, d2), dot(d1, d2));
  if (corner.radius <= 0 || turn == 0) return {.from = here, .to = here};
  const double trim = corner.radius * std::tan(std::abs(turn) / 2);
  const double side = turn > 0 ? 1 : -1;
  const Vec2 from = here - trim * d1;
  const Vec2 inward{-side * d1.y, side * d1.x};
  return {.from = from,
          .to = here + trim * d2,
          .centre = from + corner.radius * inward,
          .radius = corner.radius,
          .start = std::atan2(-inward.y, -inward.x),
          .sweep = turn,
          .trim = trim};
}

constexpr double same_place = 1e-7;  // mm: two arcs that meet leave no line between them

}  // namespace

Outline Outline::rounded(const std::vector<Corner>& corners, bool closed) {
  const std::size_t n = corners.size();
  std::vector<Rounding> roundings(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool end = !closed && (i == 0 || i + 1 == n);
    if (end) roundings[i].from = roundings[i].to = {corners[i].x, corners[i].y};
    if (!end) roundings[i] = rounding(corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]);
  }
  Outline outline;
  for (std::size_t i = 0; i < n; ++i) {
    const Rounding& r = roundings[i];
    if (r.radius > 0) outline.pieces_.push_back({Kind::arc, r.centre, {r.radius, 0}, {r.start, r.sweep}, {}});
    if (!closed && i + 1 == n) break;
    const Rounding& next = roundings[(i + 1) % n];
    const Corner &a = corners[i], &b = corners[(i + 1) % n];
    const double rest = std::hypot(b.x - a.x, b.y - a.y) - r.trim - next.trim;
    if (rest < -same_place) throw std::invalid_argument("the roundings of an outline do not fit its sides");
    if (rest > same_place) outline.pieces_.push_back({Kind::line, r.to, next.from, {}, {}});
  }
  return outline;
}

Outline Outline::closed(const std::vector<Corner>& corners) { return rounded(corners, true); }
Outline Outline::open(const std::vector<Corner>& corners) { return rounded(corners, false); }

Outline Outline::spline(const std::vector<Vec2>& controls) {
  Outline outline;
  const std::size_t n = controls.size();
  for (std::size_t i = 0; i < n; ++i) {
    outline.pieces_.push_back(
        {Kind::span, controls[i], controls[(i + 1) % n], controls[(i + 2) % n], controls[(i + 3) % n]});
  }
  return outline;
}

Outline Outline::circle(double radius) {
  Outline outline;
  for (int quarter = 0; quarter < 4; ++quarter) {
    constexpr double right_angle = std::numbers::pi / 2;
    outline.pieces_.push_back({Kind::arc, {}, {radius, 0}, {quarter * right_angle, right_angle}, {}});
  }
  return outline;
}

Outline Outline::rectangle(double width, double height, double r) {
  const double x = width / 2, y = height / 2;
  return closed({{-x, -y, r}, {x, -y, r}, {x, y, r}, {-x, y, r}});
}

const Outline::Piece& Outline::piece(double t, double& fraction) const {
  const double whole = std::clamp(std::floor(t), 0.0, static_cast<double>(pieces() - 1));
  fraction = t - whole;
  return pieces_[static_cast<std::size_t>(whole)];
}

Vec2 Outline::at(double t) const {
  double f = 0;
  const Piece& p = piece(t, f);
  if (p.kind == Kind::line) return p.a + f * (p.b - p.a);
  if (p.kind == Kind::arc) {
    const double angle = p.c.x + f * p.c.y;
    return p.a + p.b.x * Vec2{std::cos(angle), std::sin(angle)};
  }
  const double g = 1 - f, f2 = f * f, f3 = f2 * f;
  return (1.0 / 6) *
         (g * g * g * p.a + (3 * f3 - 6 * f2 + 4) * p.b + (-3 * f3 + 3 * f2 + 3 * f + 1) * p.c + f3 * p.d);
}

Vec2 Outline::normal(double t) const {
  double f = 0;
  const Piece& p = piece(t, f);
  if (p.kind == Kind::arc) {
    const double angle = p.c.x + f * p.c.y, side = p.c.y > 0 ? 1 : -1;
    return side * Vec2{std::cos(angle), std::sin(angle)};
  }
  Vec2 d = p.b - p.a;
  if (p.kind == Kind::span) {
    const double g = 1 - f;
    d = -g * g * p.a + (3 * f * f - 4 * f) * p.b + (-3 * f * f + 2 * f + 1) * p.c + f * f * p.d;
  }
  return (1 / length(d)) * Vec2{d.y, -d.x};
}

}  // namespace gabarit::motorcycle
