#include "checks/patch_curvature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gabarit {
namespace {

struct Place {
  double a, b;  // and 1 - a - b
};
// Corners, middles of the sides, centroid, and three between.
constexpr std::array<Place, 10> places{
    {{1, 0}, {0, 1}, {0, 0}, {.5, .5}, {.5, 0}, {0, .5}, {1 / 3., 1 / 3.}, {.6, .2}, {.2, .6}, {.2, .2}}};
constexpr std::array<Place, 6> directions{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}}};

class Patch {
 public:
  Patch(const BrepView& brep, const FacetOrigin& facet)
      : brep_(brep), facet_(facet), face_(brep.faces[facet.face]), surface_(brep.surfaces[face_.surface]) {}

  SharpestPoint sharpest() const {
    switch (surface_.kind) {
      case SurfaceKind::plane: return {0, parameters_at(facet_, 1 / 3., 1 / 3., 1 / 3.)};
      case SurfaceKind::cylinder:
      case SurfaceKind::sphere: return at(places[6]);
      case SurfaceKind::cone: return on_cone();
      case SurfaceKind::torus: return on_torus();
      default: return searched();
    }
  }

 private:
  SharpestPoint at_parameters(const Parameters& p) const {
    return {principal_curvatures(face_point(brep_, face_, p), face_.sign).greatest, p};
  }
  // Right at a pole the normal is rounding noise: a thousandth beside it stands for it.
  SharpestPoint at(Place w) const {
    const std::array<double, 3> weights{w.a, w.b, 1 - w.a - w.b};
    for (const std::int8_t pole : {facet_.u_pole, facet_.v_pole}) {
      if (pole < 0 || weights[static_cast<std::size_t>(pole)] < 0.999) continue;
      w = {0.999 * w.a + 0.001 / 3, 0.999 * w.b + 0.001 / 3};
    }
    return at_parameters(parameters_at(facet_, w.a, w.b, 1 - w.a - w.b));
  }

  SharpestPoint best_of(std::size_t count) const {
    SharpestPoint best = at(places[6]);
    for (std::size_t i = 0; i < count; ++i) {
      if (const SharpestPoint s = at(places[i]); s.curvature > best.curvature) best = s;
    }
    return best;
  }

  // Monotone along the axis, infinite at the apex.
  SharpestPoint on_cone() const {
    SharpestPoint best = best_of(3);
    if (facet_.u_pole >= 0 && best.curvature > 1e-9)
      best = {std::numeric_limits<double>::infinity(),
              facet_.corners[static_cast<std::size_t>(facet_.u_pole)]};
    return best;
  }

  // Monotone in cos v: the corners, and the inner and outer equator when the facet reaches across them.
  SharpestPoint on_torus() const {
    SharpestPoint best = best_of(3);
    const auto& c = facet_.corners;
    const auto [low, high] = std::minmax({c[0].v, c[1].v, c[2].v});
    for (double k = std::ceil(low / std::numbers::pi); k * std::numbers::pi < high; ++k) {
      const SharpestPoint s = at_parameters({(c[0].u + c[1].u + c[2].u) / 3, k * std::numbers::pi});
      if (s.curvature > best.curvature) best = s;
    }
    return best;
  }

  SharpestPoint searched() const {
    Place from = places[6];
    SharpestPoint best = at(from);
    double least = best.curvature;
    for (const Place& place : places) {
      const SharpestPoint s = at(place);
      least = std::min(least, s.curvature);
      if (s.curvature > best.curvature) best = s, from = place;
    }
    const bool varies = best.curvature - least > 1e-6 * best.curvature;
    return best.curvature > 1e-9 && varies ? uphill(from, best) : best;
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
};

}  // namespace

SharpestPoint sharpest_point(const BrepView& brep, const FacetOrigin& facet) {
  return Patch(brep, facet).sharpest();
}

}  // namespace gabarit
