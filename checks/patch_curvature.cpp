#include "checks/patch_curvature.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "checks/curvature_bound.h"
#include "checks/span_cuts.h"

namespace gabarit {
namespace {

struct Place {
  double a, b;  // and 1 - a - b
};
constexpr Place centroid{1 / 3., 1 / 3.};
constexpr std::array<Place, 3> corners{{{1, 0}, {0, 1}, {0, 0}}};
constexpr double nearest = 0.98;  // of the way to a pole: no place closer to it is looked at
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double flat_cone = 1e-9;  // 1/mm
constexpr double hardly = 1e-6;     // of the curvature
constexpr double far_off = 1.02;

// How far a bound may lie above the sharpest curvature found: a share of it where it is constant and where it
// varies, and 1/mm.
constexpr double without_doubt = 3e-8, settled = 1e-3, nearly_flat = 2e-4;
constexpr std::size_t most_boxes = 400, most_boxes_of_constant = 24;
constexpr std::size_t most_cells = 20'000;  // between knots: a facet over more has no bound
constexpr double beside_pole = 1e-3;        // of a facet

class Patch {
 public:
  Patch(const BrepView& brep, const FacetOrigin& facet, const FacetDomain& domain, double constant)
      : brep_(brep),
        facet_(facet),
        domain_(domain),
        constant_(constant),
        face_(brep.faces[facet.face]),
        surface_(brep.surfaces[face_.surface]) {}

  SharpestPoint sharpest() {
    switch (surface_.kind) {
      case SurfaceKind::plane: return {0, 0, parameters_at(facet_, 1 / 3., 1 / 3., 1 / 3.)};
      case SurfaceKind::cylinder:
      case SurfaceKind::sphere: return at(centroid);
      case SurfaceKind::cone: return on_cone();
      case SurfaceKind::torus: return on_torus();
      default: return constant_ > 0 ? SharpestPoint{constant_, constant_, at(centroid).at} : searched();
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
    if (const auto pole = facet_.u_pole; pole >= 0 && best.curvature > flat_cone)
      best = {infinity, infinity, facet_.corners[static_cast<unsigned char>(pole)]};
    return with_curved_sides(best);
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
    best.most = best.curvature;
    if (domain_.box.v0 < low || domain_.box.v1 > high) {
      for (double k = std::ceil(domain_.box.v0 / std::numbers::pi); k * std::numbers::pi < domain_.box.v1;
           ++k)
        best.most = std::max(best.most, at_parameters({c[0].u, k * std::numbers::pi}).curvature);
    }
    return with_curved_sides(best);
  }

  // The ends of the domain in v; without a normal there they are an apex.
  SharpestPoint with_curved_sides(SharpestPoint best) const {
    if (!(best.curvature > flat_cone)) return best;
    for (const double v : {domain_.box.v0, domain_.box.v1}) {
      const double k = at_parameters({facet_.corners[0].u, v}).curvature;
      best.most = std::max(best.most, std::isnan(k) ? infinity : k);
    }
    return best;
  }

  SharpestPoint searched() {
    SharpestPoint best = at(centroid);
    for (const Place& place : corners) {
      const SharpestPoint s = at(place);
      if (s.curvature > best.curvature || std::isnan(best.curvature)) best = s;
    }
    if (std::isnan(best.curvature)) return best;
    const double most = bound(best);
    if (most > far_off * best.curvature + nearly_flat) look_around(best);
    if (best.curvature > 0 && most - best.curvature > hardly * best.curvature) climb(best);
    return best.most = std::max(best.curvature, most), best;
  }

  // For a peak that is narrower than the boxes.
  void look_around(SharpestPoint& best) const {
    constexpr int n = 16;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; i + j <= n; ++j) {
        const SharpestPoint s = at({static_cast<double>(i) / n, static_cast<double>(j) / n});
        if (s.curvature > best.curvature) best = s;
      }
    }
  }

  struct Box {
    ParameterBox at;
    CurvatureBound bound;
    // Whatever cannot be bounded comes first; ties do not depend on the order of the boxes.
    bool operator<(const Box& b) const {
      if (bound.greatest != b.bound.greatest) return bound.greatest < b.bound.greatest;
      return at.u0 != b.at.u0 ? at.u0 < b.at.u0 : at.v0 < b.at.v0;
    }
  };

  // Of all boxes; on the way `best` becomes the sharpest of their middles.
  double bound(SharpestPoint& best) {
    std::optional<std::vector<Box>> found = cells();
    if (!found) return infinity;
    std::vector<Box>& boxes = *found;
    for (std::size_t looked_at = boxes.size(); !boxes.empty(); looked_at += 2) {
      const Box widest = boxes.front();
      const bool in_doubt = widest.bound.varies <= hardly && looked_at < most_boxes_of_constant;
      const double enough =
          in_doubt ? best.curvature * (1 + without_doubt) : best.curvature * (1 + settled) + nearly_flat;
      if (widest.bound.greatest <= std::max(nearly_flat, enough) || looked_at >= most_boxes)
        return widest.bound.greatest;
      try_out({(widest.at.u0 + widest.at.u1) / 2, (widest.at.v0 + widest.at.v1) / 2}, best);
      std::pop_heap(boxes.begin(), boxes.end());
      boxes.pop_back();
      for (const ParameterBox& half : halves(widest)) add(half, boxes);
    }
    return 0;
  }

  void try_out(const Parameters& p, SharpestPoint& best) const {
    if (!inside(p)) return;
    if (const SharpestPoint s = at_parameters(p); s.curvature > best.curvature) best = s;
  }

  bool inside(const Parameters& p) const {
    if (facet_.u_pole < 0 && facet_.v_pole < 0) return in_triangle(facet_, p);
    const auto away = [](double t, double pole, double a, double b) {
      return std::fabs(t - pole) >= (1 - nearest) * std::fabs((a + b) / 2 - pole);
    };
    const ParameterBox& d = domain_.box;
    const auto& c = facet_.corners;
    const auto n = [](int k) { return static_cast<std::size_t>(k); };
    if (facet_.u_pole >= 0 &&
        !away(p.v, c[n(facet_.u_pole)].v, c[n(facet_.u_pole + 1) % 3].v, c[n(facet_.u_pole + 2) % 3].v))
      return false;
    if (facet_.v_pole >= 0 &&
        !away(p.u, c[n(facet_.v_pole)].u, c[n(facet_.v_pole + 1) % 3].u, c[n(facet_.v_pole + 2) % 3].u))
      return false;
    return p.u >= d.u0 && p.u <= d.u1 && p.v >= d.v0 && p.v <= d.v1;
  }

  void add(const ParameterBox& at, std::vector<Box>& boxes) const {
    const std::vector<Parameters> hull = part_in(facet_, domain_, at);
    if (hull.empty()) return;
    CurvatureBound bound = curvature_bound(brep_, surface_, face_.sign, at, hull);
    if (std::isnan(bound.greatest)) bound.greatest = infinity;
    boxes.push_back({at, bound});
    std::push_heap(boxes.begin(), boxes.end());
  }

  static std::array<ParameterBox, 2> halves(const Box& box) {
    std::array<ParameterBox, 2> h{box.at, box.at};
    if (box.bound.in_u)
      h[0].u1 = h[1].u0 = box.at.u0 + (box.at.u1 - box.at.u0) / 2;
    else
      h[0].v1 = h[1].v0 = box.at.v0 + (box.at.v1 - box.at.v0) / 2;
    return h;
  }

  // The domain cut at the knots; nothing when that is too often.
  std::optional<std::vector<Box>> cells() const {
    ParameterBox d = domain_.box;
    keep_off_pole(facet_.u_pole, &Parameters::v, d.v0, d.v1);
    keep_off_pole(facet_.v_pole, &Parameters::u, d.u0, d.u1);
    const std::vector<double> u = span_cuts(brep_, surface_, 0, d.u0, d.u1),
                              v = span_cuts(brep_, surface_, 1, d.v0, d.v1);
    std::vector<Box> boxes;
    if (u.size() * v.size() > most_cells) return std::nullopt;
    for (std::size_t i = 0; i + 1 < u.size(); ++i) {
      for (std::size_t j = 0; j + 1 < v.size(); ++j) add({u[i], u[i + 1], v[j], v[j + 1]}, boxes);
    }
    return boxes;
  }

  void keep_off_pole(int pole, double Parameters::*across, double& low, double& high) const {
    if (pole < 0) return;
    const double there = facet_.corners[static_cast<std::size_t>(pole)].*across;
    (there - low < high - there ? low : high) +=
        (there - low < high - there ? 1 : -1) * beside_pole * (high - low);
  }

  // Along the sides of the triangle, which leave it on no side, and across.
  void climb(SharpestPoint& best) const {
    const auto& c = facet_.corners;
    const double u = domain_.box.u1 - domain_.box.u0, v = domain_.box.v1 - domain_.box.v0;
    const std::array<Parameters, 5> ways{{{c[1].u - c[0].u, c[1].v - c[0].v},
                                          {c[2].u - c[1].u, c[2].v - c[1].v},
                                          {c[0].u - c[2].u, c[0].v - c[2].v},
                                          {u, 0},
                                          {0, v}}};
    for (double step = 0.1; step > 1e-4;) {
      const SharpestPoint before = best;
      for (const Parameters& way : ways) {
        try_out({before.at.u + step * way.u, before.at.v + step * way.v}, best);
        try_out({before.at.u - step * way.u, before.at.v - step * way.v}, best);
      }
      if (best.curvature - before.curvature <= hardly * best.curvature) step /= 2;
    }
  }

  const BrepView& brep_;
  const FacetOrigin& facet_;
  const FacetDomain& domain_;
  double constant_;
  const Face& face_;
  const Surface& surface_;
};

}  // namespace

SharpestPoint sharpest_point(const BrepView& brep, const FacetOrigin& facet, const FacetDomain& domain,
                             double constant) {
  return Patch(brep, facet, domain, constant).sharpest();
}

}  // namespace gabarit
