#include "model/brep_kinks.h"

namespace gabarit {
namespace {

// Of a spline with flat knots: interior ones that appear at least `degree` times.
std::vector<double> repeated(const Brep& brep, std::uint32_t first, int degree, int poles) {
  std::vector<double> found;
  for (int i = degree + 1; i < poles; ++i) {
    const double* const knots = brep.knots.data() + first;
    const bool new_value = knots[i] > knots[i - 1];
    if (new_value && knots[i + degree - 1] == knots[i] && knots[i] < knots[poles]) found.push_back(knots[i]);
  }
  return found;
}

std::vector<double> of_curve(const Brep& brep, std::uint32_t number) {
  const Curve& c = brep.curves[number];
  return c.kind == CurveKind::spline ? repeated(brep, c.first_knot, c.degree, c.pole_count)
                                     : std::vector<double>{};
}

}  // namespace

std::vector<Kinks> kinks(const Brep& brep) {
  std::vector<Kinks> all(brep.surfaces.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Surface& s = brep.surfaces[i];
    if (s.kind == SurfaceKind::extrusion) all[i].u = of_curve(brep, s.curve);
    if (s.kind == SurfaceKind::revolution) all[i].v = of_curve(brep, s.curve);
    if (s.kind != SurfaceKind::spline) continue;
    all[i].u = repeated(brep, s.first_u_knot, s.u_degree, s.u_poles);
    all[i].v = repeated(brep, s.first_v_knot, s.v_degree, s.v_poles);
  }
  return all;
}

}  // namespace gabarit
