// Basis functions of splines and the quotient of rational ones (Piegl & Tiller, The NURBS Book, 1997).
#pragma once

#include "model/brep_view.h"

namespace gabarit {

constexpr int highest_degree = 25;  // OpenCASCADE's own limit; a loader refuses more

// The basis functions of one span that differ from zero, with two derivatives.
struct SplineBasis {
  int first;  // number of the pole that value[0] belongs to
  double value[highest_degree + 1], d1[highest_degree + 1], d2[highest_degree + 1];
};

// The last knot that is not above t and begins a span; the end spans continue outside.
GABARIT_HD inline int knot_span(const double* knots, int degree, int poles, double t) {
  int low = degree, high = poles;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    if (knots[middle] <= t)
      low = middle;
    else
      high = middle;
  }
  return low;
}

// From the functions of degree q - 1 at t to those of degree q, in place (the book's A2.2).
GABARIT_HD inline void raise_basis(const double* knots, int span, int q, double t, double* b) {
  double saved = 0;
  for (int r = 0; r < q; ++r) {
    const double right = knots[span + r + 1] - t, left = t - knots[span + 1 - q + r];
    const double term = b[r] / (right + left);
    b[r] = saved + right * term;
    saved = left * term;
  }
  b[q] = saved;
}

// Derivatives of the functions of degree q from functions of degree q - 1 (or from their derivatives).
GABARIT_HD inline void differentiate_basis(const double* knots, int span, int q, const double* lower,
                                           double* out) {
  double before = 0;
  for (int j = 0; j <= q; ++j) {
    const double here = j < q ? lower[j] / (knots[span + j + 1] - knots[span + j + 1 - q]) : 0;
    out[j] = q * (before - here);
    before = here;
  }
}

GABARIT_HD inline void spline_basis(const double* knots, int degree, int poles, double t,
                                    SplineBasis& basis) {
  const int span = knot_span(knots, degree, poles, t);
  basis.first = span - degree;
  double* const b = basis.value;
  double lower[highest_degree + 1] = {};
  for (int j = 0; j <= degree; ++j) b[j] = basis.d1[j] = basis.d2[j] = 0;
  b[0] = 1;
  for (int q = 1; q <= degree; ++q) {
    if (q == degree - 1) {
      differentiate_basis(knots, span, q, b, lower);  // first derivatives of degree - 1
      raise_basis(knots, span, q, t, b);
      differentiate_basis(knots, span, degree, lower, basis.d2);
    } else {
      if (q == degree) differentiate_basis(knots, span, q, b, basis.d1);
      raise_basis(knots, span, q, t, b);
    }
  }
}

GABARIT_HD inline void add_scaled(Pole& sum, const Pole& pole, double by) {
  sum.x += by * pole.x, sum.y += by * pole.y, sum.z += by * pole.z, sum.w += by * pole.w;
}
GABARIT_HD inline Vec3d numerator(const Pole& p) { return {p.x, p.y, p.z}; }

}  // namespace gabarit
