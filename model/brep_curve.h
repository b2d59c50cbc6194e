// Points and derivatives on the curves of a Brep.
#pragma once

#include "gpu/angles.h"
#include "model/brep_spline.h"

namespace gabarit {

struct CurvePoint {
  Vec3d p, d, dd;  // with the first and second derivative by t
};

GABARIT_HD inline double wrapped(double t, double first, double last) {
  return t >= first && t <= last ? t : t - (last - first) * std::floor((t - first) / (last - first));
}

GABARIT_SEPARATE GABARIT_HD inline CurvePoint spline_curve_point(const BrepView& brep, const Curve& c,
                                                                 double t) {
  SplineBasis basis;
  spline_basis(brep.knots.data + c.first_knot, c.degree, c.pole_count, t, basis);
  Pole a{0, 0, 0, 0}, d1 = a, d2 = a;
  for (int j = 0; j <= c.degree; ++j) {
    const Pole& pole = brep.poles[c.first_pole + basis.first + j];
    add_scaled(a, pole, basis.value[j]);
    add_scaled(d1, pole, basis.d1[j]);
    add_scaled(d2, pole, basis.d2[j]);
  }
  CurvePoint r;
  r.p = numerator(a) / a.w;
  r.d = (numerator(d1) - r.p * d1.w) / a.w;
  r.dd = (numerator(d2) - r.d * (2 * d1.w) - r.p * d2.w) / a.w;
  return r;
}

GABARIT_HD inline CurvePoint conic_point(const Axes& axes, double x, double dx, double ddx, double y,
                                         double dy, double ddy) {
  return {axes.origin + axes.x * x + axes.y * y, axes.x * dx + axes.y * dy, axes.x * ddx + axes.y * ddy};
}

GABARIT_SEPARATE GABARIT_HD inline CurvePoint curve_point(const BrepView& brep, const Curve& c, double t) {
  if (c.periodic) t = wrapped(t, c.first, c.last);
  switch (c.kind) {
    case CurveKind::line: break;
    case CurveKind::circle:
    case CurveKind::ellipse: {
      const double b = c.kind == CurveKind::circle ? c.radius : c.minor;
      const auto [sine, cosine] = sine_cosine(t);
      return conic_point(c.axes, c.radius * cosine, -c.radius * sine, -c.radius * cosine, b * sine,
                         b * cosine, -b * sine);
    }
    case CurveKind::hyperbola: {
      const auto [sh, ch] = hyperbolic_sine_cosine(t);
      return conic_point(c.axes, c.radius * ch, c.radius * sh, c.radius * ch, c.minor * sh, c.minor * ch,
                         c.minor * sh);
    }
    case CurveKind::parabola:
      return conic_point(c.axes, t * t / (4 * c.radius), t / (2 * c.radius), 1 / (2 * c.radius), t, 1, 0);
    case CurveKind::spline: return spline_curve_point(brep, c, t);
  }
  return {c.axes.origin + c.axes.x * t, c.axes.x, {}};
}

}  // namespace gabarit
