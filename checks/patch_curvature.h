// The sharpest point of the exact surface under a facet.
#pragma once

#include "model/brep_curvature.h"

namespace gabarit {

struct SharpestPoint {
  double curvature =
      0;  // 1/mm, convex is positive; infinite at the apex of a cone, NaN where there is no surface
  double most =
      0;  // what it is at most: no less than the curvature, more where places between are not looked at
  Parameters at;
};

// The greatest principal curvature, seen from outside, over the part of the face that the facet stands for.
// Exact on planes, cylinders, cones, spheres and tori, with `most` the same. On other surfaces the greatest
// of a grid of places, three and more in every span between knots, followed uphill until it changes by less
// than a millionth. `most` is twice as far above the grid's own as parabolas through three neighbours within
// a span could be: an estimate, not a proof, and knots closer than a sixteenth of the facet are not told
// apart.
SharpestPoint sharpest_point(const BrepView& brep, const FacetOrigin& facet);

}  // namespace gabarit
