#include "checks/patch_curvature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace gabarit {
namespace {

struct Place {
  double a, b;  // and 1 - a - b
};
constexpr Place centroid{1 / 3., 1 / 3.};
constexpr std::array<Place, 3> corners{{{1, 0}, {0, 1}, {0, 0}}};
constexpr int least_grid = 3, finest_grid = 16, in_a_span = 3;
constexpr std::array<Place, 6> directions{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}}};

class Patch {
 public:
  Patch(const BrepView& brep, const FacetOrigin& facet)
      : brep_(brep), facet_(facet), face_(brep.faces[facet.face]), surface_(brep.surfaces[face_.surface]) {}

  SharpestPoint sharpest() {
    switch (surface_.kind) {
      case SurfaceKind::plane: return {0, 0, parameters_at(facet_, 1 / 3., 1 / 3., 1 / 3.)};
      case SurfaceKind::cylinder:
      case SurfaceKind::sphere: return at(centroid);
      case SurfaceKind::cone: return on_cone();
      case SurfaceKind::torus: return on_torus();
      default: return searched();
    }
  }

 private:
  SharpestPoint at_parameters(const Parameters& p) const {
    const SurfacePoint s = face_point(brep_, face_, p);
    const bool known = outward_normal(s, face_.sign) != Vec3d{};
    const double k =
        known ? principal_curvatures(s, face_.sign).greatest : std::numeric_limits<double>::quiet_NaN();
    return {k, k, p};
  }
  // Towards a pole normal and curvature drown in rounding noise: a fiftieth of the facet beside it stands for
  // it.
  SharpestPoint at(Place w) const {
    constexpr double nearest = 0.98;
    std::array<double, 3> weights{w.a, w.b, 1 - w.a - w.b};
    const auto pull = [&](int pole) {
      if (pole < 0 || weights[static_cast<std::size_t>(pole)] <= nearest) return;
      const auto k = static_cast<std::size_t>(pole);
      weights[(k + 1) % 3] += (weights[k] - nearest) / 2;
      weights[(k + 2) % 3] += (weights[k] - nearest) / 2;
      weights[k] = nearest;
    };
    pull(facet_.u_pole);
    pull(facet_.v_pole);
    return at_parameters(parameters_at(facet_, weights[0], weights[1], weights[2]));
  }

  // Monotone between the corners, or nearly so.
  SharpestPoint best_of_corners() const {
    SharpestPoint best = at(centroid);
    for (const Place& place : corners) {
      if (const SharpestPoint s = at(place); s.curvature > best.curvature) best = s;
    }
    return best;
  }

  // Monotone along the axis, infinite at the apex.
  SharpestPoint on_cone() const {
    SharpestPoint best = best_of_corners();
    if (facet_.u_pole >= 0 && best.curvature > 1e-9)
      best = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
              facet_.corners[static_cast<std::size_t>(facet_.u_pole)]};
    return best;
  }

  // Monotone in cos v: the corners, and the inner and outer equator when the facet reaches across them.
  SharpestPoint on_torus() const {
    SharpestPoint best = best_of_corners();
    const auto& c = facet_.corners;
    const auto [low, high] = std::minmax({c[0].v, c[1].v, c[2].v});
    for (double k = std::ceil(low / std::numbers::pi); k * std::numbers::pi < high; ++k) {
      const SharpestPoint s = at_parameters({(c[0].u + c[1].u + c[2].u) / 3, k * std::numbers::pi});
      if (s.curvature > best.curvature) best = s;
    }
    return best;
  }

  SharpestPoint searched() {
    const int n = grid_size();
    const std::vector<Node> nodes = grid(n);
    Place from = centroid;
    SharpestPoint best = at(from);
    double least = best.curvature;
    for (const Node& node : nodes) {
      least = std::min(least, node.point.curvature);
      if (node.point.curvature > best.curvature || std::isnan(best.curvature))
        best = node.point, from = node.place;
    }
    const bool varies = best.curvature - least > 1e-6 * best.curvature;
    if (!(best.curvature > 1e-9) || !varies) return best;
    const double most = most_between(nodes, n);
    best = uphill(from, best);
    best.most = std::max(best.curvature, most);
    return best;
  }

  struct Node {
    Place place{};
    SharpestPoint point;
    std::array<std::size_t, 2> span{};
  };

  // Row by row: node (i, j) of the grid has the number j + i·(2n + 3 - i)/2.
  static std::size_t number(int n, int i, int j) {
    return static_cast<std::size_t>(j) +
           static_cast<std::size_t>(i) * static_cast<std::size_t>(2 * n + 3 - i) / 2;
  }

  std::vector<Node> grid(int n) const {
    std::vector<Node> nodes;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; i + j <= n; ++j) {
        Node node;
        node.place = {static_cast<double>(i) / n, static_cast<double>(j) / n};
        node.point = at(node.place);
        node.span = {span_of(knots_[0], node.point.at.u), span_of(knots_[1], node.point.at.v)};
        nodes.push_back(node);
      }
    }
    return nodes;
  }
  static std::size_t span_of(const std::vector<double>& knots, double t) {
    return static_cast<std::size_t>(std::upper_bound(knots.begin(), knots.end(), t) - knots.begin());
  }

  // Over all runs of three neighbours within one span.
  static double most_between(const std::vector<Node>& nodes, int n) {
    double most = 0;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; i + j <= n; ++j) {
        for (const auto& [di, dj] : {std::pair{1, 0}, {0, 1}, {1, -1}}) {
          if (i + 2 * di > n || j + 2 * dj < 0 || i + 2 * di + j + 2 * dj > n) continue;
          const Node& a = nodes[number(n, i, j)];
          const Node& b = nodes[number(n, i + di, j + dj)];
          const Node& c = nodes[number(n, i + 2 * di, j + 2 * dj)];
          if (a.span != b.span || b.span != c.span) continue;
          const double x = a.point.curvature, y = b.point.curvature, z = c.point.curvature;
          // A parabola rises by no more than an eighth of it over its samples.
          const double bend = std::fabs(x - 2 * y + z) / 4;
          if (std::max({x, y, z}) + bend > most) most = std::max({x, y, z}) + bend;
        }
      }
    }
    return most;
  }

  // As fine as the narrowest span between knots asks for; notes the knots.
  int grid_size() {
    if (surface_.kind == SurfaceKind::spline) {
      note_knots(0, surface_.first_u_knot, surface_.u_poles + surface_.u_degree + 1);
      note_knots(1, surface_.first_v_knot, surface_.v_poles + surface_.v_degree + 1);
    } else if (surface_.curve != no_number && brep_.curves[surface_.curve].kind == CurveKind::spline) {
      const Curve& c = brep_.curves[surface_.curve];
      note_knots(surface_.kind == SurfaceKind::extrusion ? 0 : 1, c.first_knot, c.pole_count + c.degree + 1);
    }
    int n = least_grid;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [low, high] = range(k);
      double narrowest = high - low, before = low;
      for (const double knot : knots_[k]) narrowest = std::min(narrowest, knot - before), before = knot;
      narrowest = std::min(narrowest, high - before);
      if (narrowest > 0 && !knots_[k].empty())
        n = std::max(n, static_cast<int>(
                            std::min<double>(finest_grid, std::ceil(in_a_span * (high - low) / narrowest))));
    }
    return n;
  }
  std::pair<double, double> range(std::size_t k) const {
    const auto& c = facet_.corners;
    return k == 0 ? std::minmax({c[0].u, c[1].u, c[2].u}) : std::minmax({c[0].v, c[1].v, c[2].v});
  }
  // Those inside the facet, each once, in the facet's own turn of a periodic parameter.
  void note_knots(std::size_t k, std::uint32_t first, std::int32_t count) {
    const auto [low, high] = range(k);
    const ParameterBox& d = surface_.domain;
    const bool periodic = k == 0 ? surface_.u_periodic : surface_.v_periodic;
    const double start = k == 0 ? d.u0 : d.v0, period = k == 0 ? d.u1 - d.u0 : d.v1 - d.v0;
    const double turn = periodic && period > 0 ? period * std::floor((low - start) / period) : 0;
    std::vector<double>& knots = knots_[k];
    for (std::int32_t i = 0; i < count; ++i) {
      for (const double t : {brep_.knots[first + i] + turn, brep_.knots[first + i] + turn + period}) {
        if (t > low && t < high && (t == brep_.knots[first + i] + turn || periodic)) knots.push_back(t);
      }
    }
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  }

  SharpestPoint uphill(Place from, SharpestPoint best) const {
    for (double step = 0.15; step > 1e-4;) {
      const double before = best.curvature;
      const Place centre = from;
      for (const Place& d : directions) {
        const Place to{centre.a + step * d.a, centre.b + step * d.b};
        if (to.a < 0 || to.b < 0 || to.a + to.b > 1) continue;
        if (const SharpestPoint s = at(to); s.curvature > best.curvature) best = s, from = to;
      }
      if (best.curvature - before <= 1e-6 * best.curvature) step /= 2;
    }
    return best;
  }

  const BrepView& brep_;
  const FacetOrigin& facet_;
  const Face& face_;
  const Surface& surface_;
  std::array<std::vector<double>, 2> knots_;  // of u and v, inside the facet
};

}  // namespace

SharpestPoint sharpest_point(const BrepView& brep, const FacetOrigin& facet) {
  return Patch(brep, facet).sharpest();
}

}  // namespace gabarit
