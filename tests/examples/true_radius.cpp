#include "tests/examples/true_radius.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gabarit::motorcycle {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Cell {
  std::size_t row, column, half;  // half 0 or 1 of a quad
  bool first_fan, last_fan;
};

Cell cell_of(const Surface& surface, const Grid& grid, std::size_t facet) {
  const std::size_t columns = grid.v.size() - 1, rows = grid.u.size() - 1;
  if (surface.ring) return {facet / (2 * columns), facet % (2 * columns) / 2, facet % 2, false, false};
  if (facet < columns) return {0, facet, 0, true, false};
  const std::size_t rest = facet - columns, row = 1 + rest / (2 * columns);
  if (row + 1 == rows) return {row, rest % (2 * columns), 0, false, true};
  return {row, rest % (2 * columns) / 2, rest % 2, false, false};
}

Vec3d du(const Surface& s, Vec2 at, double d) { return s.at(at.x + d, at.y) - s.at(at.x - d, at.y); }
Vec3d dv(const Surface& s, Vec2 at, double d) { return s.at(at.x, at.y + d) - s.at(at.x, at.y - d); }

Vec3d normal(const Surface& s, Vec2 at, Vec2 d) {
  const Vec3d n = normalized(cross(du(s, at, d.x), dv(s, at, d.y)));
  return s.flipped ? -n : n;
}

// The step of differences: about a twentieth of a millimetre, but inside.
double difference(double length, double half_width) {
  return std::min(0.9 * half_width, 0.05 * half_width / std::max(length, 1e-9));
}

bool on_break(const std::vector<double>& breaks, double t) {
  return std::any_of(breaks.begin(), breaks.end(), [&](double b) { return b == t; });
}

}  // namespace

ParameterTriangle parameters(const Surface& surface, const Grid& grid, std::size_t facet) {
  const Cell c = cell_of(surface, grid, facet);
  const double u0 = grid.u[c.row], u1 = grid.u[c.row + 1], v0 = grid.v[c.column], v1 = grid.v[c.column + 1];
  if (c.first_fan) return {{Vec2{u0, v0}, {u1, v0}, {u1, v1}}};
  if (c.last_fan) return {{Vec2{u0, v0}, {u1, v0}, {u0, v1}}};
  const Vec2 p{u0, v0}, q{u1, v0}, r{u1, v1}, s{u0, v1};
  const auto at = [&](Vec2 place) { return surface.at(place.x, place.y); };
  if (splits_at_first(surface, {u0, u1, v0, v1, {at(p), at(q), at(r), at(s)}}))
    return c.half == 0 ? ParameterTriangle{{p, q, r}} : ParameterTriangle{{p, r, s}};
  return c.half == 0 ? ParameterTriangle{{p, q, s}} : ParameterTriangle{{q, r, s}};
}

double convex_radius(const Surface& s, Vec2 at, Vec2 half_width) {
  const double hu = difference(length(du(s, at, half_width.x)) / 2, half_width.x);
  const double hv = difference(length(dv(s, at, half_width.y)) / 2, half_width.y);
  const Vec3d n = normal(s, at, {hu, hv}), here = s.at(at.x, at.y);
  const Vec3d su = du(s, at, hu) / (2 * hu), sv = dv(s, at, hv) / (2 * hv);
  const double e = dot(su, su), f = dot(su, sv), g = dot(sv, sv);
  const auto second = [&](double a, double b) { return s.at(at.x + a, at.y + b); };
  const double l = -dot(n, second(hu, 0) - 2 * here + second(-hu, 0)) / (hu * hu);
  const double k = -dot(n, second(0, hv) - 2 * here + second(0, -hv)) / (hv * hv);
  const double m =
      -dot(n, second(hu, hv) - second(hu, -hv) - second(-hu, hv) + second(-hu, -hv)) / (4 * hu * hv);
  const double area = e * g - f * f;
  const double mean = (l * g - 2 * m * f + k * e) / (2 * area), gauss = (l * k - m * m) / area;
  const double curvature = mean + std::sqrt(std::max(0.0, mean * mean - gauss));
  return curvature > 1e-9 ? 1 / curvature : infinite;
}

bool convex_crease(const Surface& s, Vec2 at, bool along_u) {
  constexpr double aside = 1e-3, d = 2e-4;
  Vec2 before = at, after = at;
  if (along_u) {
    const double period = s.u_breaks.back() - s.u_breaks.front();
    before.x -= aside, after.x += aside;
    if (s.ring && before.x < s.u_breaks.front()) before.x += period;
    if (s.ring && after.x > s.u_breaks.back()) after.x -= period;
    if (before.x < s.u_breaks.front() || after.x > s.u_breaks.back()) return false;
  } else {
    const double period = s.v_breaks.back() - s.v_breaks.front();
    before.y -= aside, after.y += aside;
    if (before.y < s.v_breaks.front()) before.y += period;
    if (after.y > s.v_breaks.back()) after.y -= period;
  }
  const Vec3d n1 = normal(s, before, {d, d}), n2 = normal(s, after, {d, d});
  const Vec3d across = s.at(after.x, after.y) - s.at(before.x, before.y);
  return dot(n1, n2) < std::cos(0.0175) && dot(n2 - n1, across) > 0;
}

static double touched_radius(const Surface& surface, const Grid& grid, std::size_t facet,
                             const std::array<Selected, 3>& edges, bool flipped) {
  const auto [corners] = parameters(surface, grid, facet);
  const auto middle = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
  double width_u = 0, width_v = 0;
  for (const Vec2& c : corners) {
    width_u = std::max(width_u, std::abs(c.x - middle.x)),
    width_v = std::max(width_v, std::abs(c.y - middle.y));
  }
  double radius = convex_radius(surface, middle, {width_u / 2, width_v / 2});
  for (std::size_t e = 0; e < 3; ++e) {
    if (edges[e] == Selected::no) continue;
    // A flipped facet lists its corners as 0, 2, 1.
    const std::array<std::size_t, 3> order =
        flipped ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2};
    const Vec2 a = corners[order[e]], b = corners[order[(e + 1) % 3]], m = 0.5 * (a + b);
    const bool line_u = a.x == b.x && on_break(surface.u_breaks, a.x);
    const bool line_v = a.y == b.y && on_break(surface.v_breaks, a.y);
    if ((line_u && convex_crease(surface, m, true)) || (line_v && convex_crease(surface, m, false)))
      radius = 0;
  }
  return radius;
}

std::vector<TouchedPart> touched_parts(const Parts& parts, const std::vector<Grid>& grids,
                                       const Region& region) {
  std::vector<TouchedPart> all;
  auto grid = grids.begin();
  FacetId facet = 0;
  for (const Part& part : parts) {
    TouchedPart touched;
    touched.radius = infinite;
    for (const Surface& surface : part.surfaces) {
      const std::size_t count = grid->facet_count(surface.ring);
      for (std::size_t i = 0; i < count; ++i, ++facet) {
        if (region.facets[facet] == Selected::no) continue;
        ++(region.facets[facet] == Selected::yes ? touched.yes : touched.maybe);
        const double radius = touched_radius(surface, *grid, i, region.edges[facet], surface.flipped);
        if (radius >= touched.radius) continue;
        const auto [c] = parameters(surface, *grid, i);
        touched.radius = radius;
        touched.at = surface.at(c[0].x, c[0].y);
      }
      ++grid;
    }
    all.push_back(touched);
  }
  return all;
}

}  // namespace gabarit::motorcycle
