// A bound of the curvature of a surface over a part of a box of its parameters.
#pragma once

#include <span>

#include "model/brep_view.h"

namespace gabarit {

struct CurvatureBound {
  double greatest = 0;  // 1/mm: nothing in the box is more convex; infinite or NaN where nothing is known
  double varies = 0;    // about how much the curvature changes over the box, as a share of it
  bool in_u = false;    // halving the box in u tells more than in v
};

// Of a spline, an extrusion or a revolution over the convex hull of some parameters; `sign` as in Face. The
// hull lies in the box and the box inside one span between knots and one turn, ends included. First and
// second fundamental form are enclosed by Taylor models of the span's polynomials, rounding included, so the
// bound holds for every point; it comes closer to the truth by about 1/64 when the box is halved both ways,
// or by 1/4 where the curvature varies. Along z an extrusion does not change, nor does a revolution around
// its axis: only the range of the curve's parameter matters there.
CurvatureBound curvature_bound(const BrepView& brep, const Surface& surface, double sign,
                               const ParameterBox& box, std::span<const Parameters> hull);

}  // namespace gabarit
