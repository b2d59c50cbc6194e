#include "checks/curvature_bound.h"

#include <algorithm>
#include <vector>

#include "checks/taylor_surface.h"

namespace gabarit {
namespace {

// The terms of some orders that change along x and along y, against the size of the model.
struct Changes {
  int first_order;
  double x = 0, y = 0;

  void add(const TaylorModel& a, double size) {
    if (!(size > 0)) return;
    for (int m = first_order; m <= taylor_order; ++m) {
      for (int j = 0; j <= m; ++j) {
        const double share = std::fabs(a.c[static_cast<std::size_t>(taylor_term(m - j, j))]) / size;
        x += share * (m - j), y += share * j;
      }
    }
  }
  bool more_along_x() const { return !(x < y); }
};

// x and y in the box; of an extrusion and a revolution x stands for the parameter of their curve.
std::vector<TaylorPlace> places(const Surface& surface, const ParameterBox& box,
                                std::span<const Parameters> hull) {
  const auto share = [](double t, double low, double high) {
    return high > low ? std::clamp(2 * (t - low) / (high - low) - 1, -1.0, 1.0) : 0;
  };
  std::vector<TaylorPlace> found;
  found.reserve(hull.size());
  for (const Parameters& p : hull) {
    const double u = share(p.u, box.u0, box.u1), v = share(p.v, box.v0, box.v1);
    found.push_back(surface.kind == SurfaceKind::revolution ? TaylorPlace{v, 0} : TaylorPlace{u, v});
  }
  return found;
}

// The shape operator in a frame whose first vector runs along u: [a b; b c], convex is positive.
struct ShapeOperator {
  TaylorModel a, b, c;
};

// The greater eigenvalue grows with a, with c and with the size of b.
double greatest_eigenvalue(double a, double b, double c) {
  const double root = std::hypot((a - c) / 2, b);
  return (a + c) / 2 + root + 8 * unit_roundoff * (std::fabs(a) + std::fabs(c) + root);
}

double changes(const TaylorModel& a) { return norm(a) - std::fabs(a.c[0]); }

// Whether what a plane leaves over of the curvature is more along x.
bool bends_along_x(const TaylorModel& a) {
  return !(std::fabs(a.c[taylor_term(2, 0)]) < std::fabs(a.c[taylor_term(0, 2)]));
}

// `cut_off_along_x`: the same of what is cut off from the forms.
void bound_eigenvalue(const ShapeOperator& s, std::span<const TaylorPlace> hull, bool cut_off_along_x,
                      CurvatureBound& bound) {
  const TaylorModel half = (s.a - s.c) * 0.5;
  const TaylorModel curvature = (s.a + s.c) * 0.5 + power(half * half + s.b * s.b, 0.5);
  const double apart = greatest_eigenvalue(greatest(s.a, hull), greatest_size(s.b), greatest(s.c, hull)),
               together = greatest(curvature, hull);
  bound.greatest = together < apart ? together : apart;
  // Of no meaning where the two curvatures may be equal, and infinite then.
  const double change = changes(curvature) + (std::isfinite(curvature.r) ? 0 : curvature.r);
  bound.varies =
      std::min(change, std::max({changes(s.a), changes(s.b), changes(s.c)})) / std::fabs(bound.greatest);
  const bool bends = curvature.r < 0.1 * change;
  bound.in_u = bends ? bends_along_x(curvature) : cut_off_along_x;
}

}  // namespace

CurvatureBound curvature_bound(const BrepView& brep, const Surface& surface, double sign,
                               const ParameterBox& box, std::span<const Parameters> hull) {
  const TaylorSurface s = taylor_surface(brep, surface, box);
  const TaylorVector n = cross(s.u, s.v);
  const TaylorModel e = dot(s.u, s.u), f = dot(s.u, s.v), g = dot(s.v, s.v), area = dot(n, n);
  const TaylorModel root = power(area, -0.5), outward_scale = s.scale * root * -sign;
  const TaylorModel l = dot(s.uu, n) * outward_scale, m = dot(s.uv, n) * outward_scale,
                    k = dot(s.vv, n) * outward_scale;
  ShapeOperator w;
  w.a = l * power(e, -1);
  const TaylorModel t = m - w.a * f;
  w.b = t * root;
  w.c = (k * e - m * f - f * t) * (root * root);
  // What is cut off beyond the last orders is like these; where nothing could be bounded all orders count.
  Changes last{taylor_order - 1}, all{1};
  for (const TaylorModel* form : {&e, &g, &area}) last.add(*form, form->c[0]), all.add(*form, form->c[0]);
  const double size = std::fabs(w.a.c[0]) + std::fabs(w.b.c[0]) + std::fabs(w.c.c[0]);
  for (const TaylorModel* part : {&w.a, &w.b, &w.c}) last.add(*part, size);
  CurvatureBound bound;
  const bool nothing = !std::isfinite(w.a.r + w.c.r);
  bound_eigenvalue(w, places(surface, box, hull), (nothing ? all : last).more_along_x(), bound);
  if (surface.kind != SurfaceKind::spline) bound.in_u = surface.kind == SurfaceKind::extrusion;
  return bound;
}

}  // namespace gabarit
