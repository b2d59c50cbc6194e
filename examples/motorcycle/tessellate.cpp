#include "examples/motorcycle/tessellate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gabarit::motorcycle {

namespace {

constexpr double rounding = 6;   // mm: up to this radius edges are as long as the step
constexpr double straight = 40;  // steps: the longest edge
constexpr int probes = 16;       // of the curvature between two breaks, along the lines' direction…
constexpr int cross_probes = 6;  // …and across it
constexpr double margin = 0.99;  // of the length allowed, for what happens between the probes

double circumradius(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const double area = length(cross(b - a, c - a));
  const double sides = length(b - a) * length(c - b) * length(c - a);
  return area > 1e-9 * sides ? sides / (2 * area) : std::numeric_limits<double>::infinity();
}

using Curve = std::function<Vec3d(double t, double across)>;

// How many edges a unit of t needs around t, at the place across that needs most.
double density(const Curve& curve, double t, double delta, const std::vector<double>& across,
               const Tessellation& tessellation) {
  double most = 0;
  for (const double s : across) {
    const Vec3d a = curve(t - delta, s), b = curve(t, s), c = curve(t + delta, s);
    const double speed = (length(b - a) + length(c - b)) / (2 * delta);
    most = std::max(most, speed / (margin * longest_edge(circumradius(a, b, c), tessellation)));
  }
  return most;
}

// Adds the lines after `from` up to and with `to`, each with the same share of the density.
void add_lines(const std::vector<double>& densities, double from, double to, std::vector<double>& lines) {
  double total = 0;
  for (const double d : densities) total += d;
  const double width = (to - from) / static_cast<double>(densities.size());
  const auto count = static_cast<int>(std::max(1.0, std::ceil(total * width - 1e-9)));
  double passed = 0;
  std::size_t cell = 0;
  for (int i = 1; i < count; ++i) {
    const double wanted = total * i / count;
    while (cell + 1 < densities.size() && passed + densities[cell] < wanted) passed += densities[cell++];
    lines.push_back(from + width * (static_cast<double>(cell) + (wanted - passed) / densities[cell]));
  }
  lines.push_back(to);
}

std::vector<double> probe_places(const std::vector<double>& breaks, int count) {
  std::vector<double> places;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    for (int k = 0; k < count; ++k)
      places.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * (k + 0.5) / count);
  }
  return places;
}

std::vector<double> lines(const Curve& curve, const std::vector<double>& breaks, bool smooth,
                          const std::vector<double>& across, const Tessellation& tessellation) {
  std::vector<double> all{breaks.front()};
  std::vector<double> densities;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double from = breaks[i], width = (breaks[i + 1] - from) / probes;
    for (int k = 0; k < probes; ++k)
      densities.push_back(density(curve, from + width * (k + 0.5), width / 2, across, tessellation));
    if (smooth) continue;
    add_lines(densities, from, breaks[i + 1], all);
    densities.clear();
  }
  if (smooth) add_lines(densities, breaks.front(), breaks.back(), all);
  return all;
}

struct Row {
  double u = 0;
  std::vector<Vec3d> points;
};

// The facets between two rows of points; a row of one point is an end of the surface.
class Strips {
 public:
  Strips(const Surface& surface, const Grid& grid, const FacetSink& sink)
      : surface_(surface), grid_(grid), sink_(sink) {}

  void between(const Row& first, const Row& second) const {
    const auto &a = first.points, &b = second.points;
    const std::size_t columns = std::max(a.size(), b.size());
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t next = i + 1 < columns ? i + 1 : 0;
      if (a.size() == 1)
        facet(a[0], b[i], b[next]);
      else if (b.size() == 1)
        facet(a[i], b[0], a[next]);
      else
        quad({first.u, second.u, grid_.v[i], grid_.v[i + 1], {a[i], b[i], b[next], a[next]}});
    }
  }

 private:
  void quad(const Quad& quad) const {
    const auto& [a, b, c, d] = quad.corners;
    if (splits_at_first(surface_, quad))
      facet(a, b, c), facet(a, c, d);
    else
      facet(a, b, d), facet(b, c, d);
  }
  void facet(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
    surface_.flipped ? sink_(a, c, b) : sink_(a, b, c);
  }

  const Surface& surface_;
  const Grid& grid_;
  const FacetSink& sink_;
};

}  // namespace

bool splits_at_first(const Surface& surface, const Quad& quad) {
  const auto& [a, b, c, d] = quad.corners;
  const double size = squared_length(c - a) + squared_length(d - b);
  const Vec3d normal = cross(c - a, d - b);
  const bool flat = std::abs(dot(a - b, normal)) <= 1e-6 * size * std::sqrt(size);
  if (flat) return squared_length(c - a) <= squared_length(d - b);
  const Vec3d middle = surface.at((quad.u0 + quad.u1) / 2, (quad.v0 + quad.v1) / 2);
  return std::abs(dot(a - middle, normal)) <= std::abs(dot(b - middle, normal));
}

double longest_edge(double radius, const Tessellation& t) {
  // A quad's diagonal departs from the surface by what its two sides do, added: each gets half of the sag.
  const double by_sag = std::sqrt(8 * (t.sag / 2) * radius);
  const double by_step = t.step * std::clamp(std::sqrt(radius / rounding), 1.0, straight);
  return std::min(by_sag, by_step);
}

std::size_t Grid::facet_count(bool ring) const {
  const std::size_t rows = u.size() - 1, columns = v.size() - 1;
  return columns * (2 * rows - (ring ? 0 : 2));
}

Grid grid(const Surface& surface, const Tessellation& tessellation) {
  const auto along_u = [&](double t, double across) { return surface.at(t, across); };
  const auto along_v = [&](double t, double across) { return surface.at(across, t); };
  return {lines(along_u, surface.u_breaks, surface.smooth_u, probe_places(surface.v_breaks, cross_probes),
                tessellation),
          lines(along_v, surface.v_breaks, surface.smooth_v, probe_places(surface.u_breaks, cross_probes),
                tessellation)};
}

void tessellate(const Surface& surface, const Grid& grid, const FacetSink& sink) {
  const std::size_t rows = grid.u.size(), columns = grid.v.size() - 1;
  const auto row = [&](std::size_t i) {
    const bool end = !surface.ring && (i == 0 || i + 1 == rows);
    Row made{grid.u[i], std::vector<Vec3d>(end ? 1 : columns)};
    for (std::size_t k = 0; k < made.points.size(); ++k) made.points[k] = surface.at(made.u, grid.v[k]);
    return made;
  };
  const Strips strips(surface, grid, sink);
  const Row first = row(0);
  Row before = first;
  for (std::size_t i = 1; i < rows; ++i) {
    Row next = surface.ring && i + 1 == rows ? Row{grid.u[i], first.points} : row(i);
    strips.between(before, next);
    before = std::move(next);
  }
}

}  // namespace gabarit::motorcycle
