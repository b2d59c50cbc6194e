#include "tests/checks/fillets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace gabarit::fillets {

namespace {

using shapes::Point2;

// Arc length across the edge from the first tangent line, and length along it.
Vec3d surface(const Fillet& fillet, const Point2& p) {
  const double arc = fillet.radius * fillet.angle;
  if (p.x < 0) return {p.x, p.y, 0};
  const double t = std::min(p.x, arc) / fillet.radius;
  const Vec3d on_arc{fillet.radius * std::sin(t), p.y, fillet.radius * (std::cos(t) - 1)};
  return on_arc + Vec3d{std::cos(fillet.angle), 0, -std::sin(fillet.angle)} * std::max(0.0, p.x - arc);
}

struct Grid {
  std::vector<double> across;
  int rim = 0, strips = 0, along = 0;  // index of the first tangent line, chords of the rounding, cells
};

Grid grid(const Fillet& f) {
  const bool strips = f.meshing == Meshing::long_strips;
  const double arc = f.radius * f.angle;
  Grid g;
  g.strips = std::max(1, static_cast<int>(std::ceil(arc / f.step - 1e-9)));
  g.rim = strips ? 1 : std::max(1, static_cast<int>(f.plane / f.step));
  g.along = strips ? 3 : static_cast<int>(std::ceil(f.length / f.step));
  for (int i = g.rim; i > 0; --i) g.across.push_back(-f.plane * i / g.rim);
  for (int i = 0; i <= g.strips; ++i) g.across.push_back(arc * i / g.strips);
  for (int i = 1; i <= g.rim; ++i) g.across.push_back(arc + f.plane * i / g.rim);
  return g;
}

Part part_of(const Fillet& f, const std::array<Point2, 3>& t) {
  const double arc = f.radius * f.angle;
  const auto [low, high] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [near, far] = std::minmax({t[0].y, t[1].y, t[2].y});
  const bool open = near < 1e-6 || far > f.length - 1e-6;
  if (open || low < 1e-6 - f.plane || high > arc + f.plane - 1e-6) return Part::border;
  if (low >= -1e-9 && high <= arc + 1e-9) return Part::rounding;
  if (high <= 1e-9 || low >= arc - 1e-9) return Part::plane;
  return std::min(high, arc) - std::max(low, 0.0) > 0.3 * (high - low) ? Part::across : Part::border;
}

}  // namespace

Meshed mesh(const Fillet& f, unsigned seed) {
  const Grid g = grid(f);
  std::mt19937 random(seed);
  const auto moved = [&](double by) {  // the same on every library, unlike its distributions
    return by * 0.25 * (2.0 * static_cast<double>(random()) / 4294967296.0 - 1.0);
  };
  const auto columns = g.across.size();
  const auto rows = static_cast<std::size_t>(g.along) + 1;
  std::vector<std::vector<Point2>> corner(columns, std::vector<Point2>(rows));
  for (std::size_t i = 0; i < columns; ++i) {
    const auto line = static_cast<int>(i);
    const bool rim = line == g.rim || line == g.rim + g.strips;
    for (std::size_t j = 0; j < rows; ++j) {
      Point2& p = corner[i][j] = {g.across[i], f.length * static_cast<double>(j) / g.along};
      if (f.meshing < Meshing::jittered || i == 0 || i + 1 == columns || j == 0 || j + 1 == rows) continue;
      const double room = std::min(g.across[i] - g.across[i - 1], g.across[i + 1] - g.across[i]);
      if (!rim || f.meshing == Meshing::unmarked) p.x += moved(room);
      p.y += moved(f.length / g.along);
    }
  }
  Meshed out;
  const auto add = [&](const Point2& a, const Point2& b, const Point2& c) {
    out.triangles.push_back({surface(f, a), surface(f, b), surface(f, c)});
    out.part.push_back(part_of(f, {a, b, c}));
  };
  for (std::size_t i = 0; i + 1 < columns; ++i) {
    for (std::size_t j = 0; j + 1 < rows; ++j) {
      const Point2 &a = corner[i][j], &b = corner[i + 1][j], &c = corner[i + 1][j + 1], &d = corner[i][j + 1];
      const bool other_diagonal = f.meshing > Meshing::jittered && random() % 2 == 0;
      add(a, b, other_diagonal ? d : c);
      add(other_diagonal ? b : a, c, d);
    }
  }
  // Jitter makes chords longer by half; the sag grows with their square.
  const double chord_sag = f.radius * (1 - std::cos(0.5 * f.angle / g.strips));
  out.sag = std::max(0.1, chord_sag * (f.meshing < Meshing::jittered ? 1.0 : 2.25));
  return out;
}

shapes::Triangles rounded_box(double size, double radius, int steps) {
  // A sphere cut into octants that are moved apart: directions on a grid with doubled quarter lines.
  struct Ring {
    double angle, offset;
  };
  const double half = 0.5 * size - radius;
  std::vector<Ring> around, up;
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (int i = 0; i <= steps; ++i)
      around.push_back({(quarter + static_cast<double>(i) / steps) * std::numbers::pi / 2, quarter + 0.5});
  }
  for (int side = -1; side <= 1; side += 2) {
    for (int i = 0; i <= steps; ++i)
      up.push_back({(static_cast<double>(i) / steps - (side < 0 ? 1 : 0)) * std::numbers::pi / 2,
                    static_cast<double>(side)});
  }
  const auto at = [&](const Ring& a, const Ring& u) {
    const double turn = a.offset * std::numbers::pi / 2;
    const Vec3d centre{half * std::sqrt(2.0) * std::cos(turn), half * std::sqrt(2.0) * std::sin(turn),
                       half * u.offset};
    // Rounded, so that corners of neighbouring quads are the same to the last bit.
    const auto exact = [](double x) { return std::round(x * 1e9) / 1e9; };
    const Vec3d p = centre + radius * Vec3d{std::cos(u.angle) * std::cos(a.angle),
                                            std::cos(u.angle) * std::sin(a.angle), std::sin(u.angle)};
    return Vec3d{exact(p.x), exact(p.y), exact(p.z)};
  };
  shapes::Triangles out;
  const auto add = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    if (length(cross(b - a, c - a)) > 1e-6) out.push_back({a, b, c});
  };
  for (std::size_t k = 0; k < around.size(); ++k) {
    const Ring &a = around[k], &b = around[(k + 1) % around.size()];
    for (std::size_t j = 0; j + 1 < up.size(); ++j) {
      add(at(a, up[j]), at(b, up[j]), at(b, up[j + 1]));
      add(at(a, up[j]), at(b, up[j + 1]), at(a, up[j + 1]));
    }
  }
  for (const Ring& u : {up.front(), up.back()}) {
    std::array<Vec3d, 4> cap;
    for (std::size_t q = 0; q < 4; ++q) cap[q] = at(around[q * (static_cast<std::size_t>(steps) + 1)], u);
    if (u.offset < 0) std::swap(cap[1], cap[3]);
    add(cap[0], cap[1], cap[2]);
    add(cap[0], cap[2], cap[3]);
  }
  return out;
}

}  // namespace gabarit::fillets
