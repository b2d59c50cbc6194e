// The sharpest point of the exact surface under a facet.
#pragma once

#include "model/brep_curvature.h"

namespace gabarit {

struct SharpestPoint {
  double curvature = 0;  // 1/mm, convex is positive; infinite at the apex of a cone
  Parameters at;
};

// The greatest principal curvature, seen from outside, over the part of the face that the facet stands for.
// Exact on planes, cylinders, cones, spheres and tori. On other surfaces the greatest of ten places, followed
// uphill until it changes by less than a millionth: a peak narrower than a facet that none of the ten feels
// is missed.
SharpestPoint sharpest_point(const BrepView& brep, const FacetOrigin& facet);

}  // namespace gabarit
