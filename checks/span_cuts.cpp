#include "checks/span_cuts.h"

#include <cmath>
#include <limits>

namespace gabarit {
namespace {

View<const double> knots_of(const BrepView& brep, const Surface& s, int along) {
  if (s.kind == SurfaceKind::spline) {
    const bool u = along == 0;
    return {brep.knots.data + (u ? s.first_u_knot : s.first_v_knot),
            u ? s.u_poles + s.u_degree + 1 : s.v_poles + s.v_degree + 1};
  }
  const bool curved = along == (s.kind == SurfaceKind::extrusion ? 0 : 1);
  if (s.curve == no_number || !curved || brep.curves[s.curve].kind != CurveKind::spline) return {};
  const Curve& c = brep.curves[s.curve];
  return {brep.knots.data + c.first_knot, c.pole_count + c.degree + 1};
}

}  // namespace

std::vector<double> span_cuts(const BrepView& brep, const Surface& surface, int along, double low,
                              double high) {
  const View<const double> knots = knots_of(brep, surface, along);
  const ParameterBox& d = surface.domain;
  const double start = along == 0 ? d.u0 : d.v0, end = along == 0 ? d.u1 : d.v1;
  const double turn = (along == 0 ? surface.u_periodic : surface.v_periodic) && end > start ? end - start : 0;
  std::vector<double> cuts{low};
  for (double shift = turn > 0 ? turn * std::floor((low - start) / turn) : 0;; shift += turn) {
    for (std::int64_t i = 0; i < knots.size; ++i) {
      if (const double t = knots[i] + shift; t > cuts.back() && t < high) cuts.push_back(t);
    }
    if (turn == 0 || start + shift + turn > high) break;
  }
  cuts.push_back(high);
  return cuts;
}

}  // namespace gabarit
