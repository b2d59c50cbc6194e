// The sharpest point of the exact surface under a facet.
#pragma once

#include "checks/facet_domain.h"
#include "model/brep_curvature.h"

namespace gabarit {

struct SharpestPoint {
  double curvature =
      0;            // 1/mm, convex is positive; infinite at the apex of a cone, NaN where there is no surface
  double most = 0;  // what it is at most anywhere in the facet's domain, proven; no less than the curvature
  Parameters at;
};

// The greatest principal curvature, seen from outside, over the part of the face that the facet stands for.
// Planes, cylinders, cones, spheres and tori tell it by their kind. On splines, extrusions and revolutions it
// is that of the sharpest place found, and `most` bounds all of the domain, box by box (curvature_bound):
// boxes are halved until it is within 3e-8 of the curvature where that is constant (or 24 boxes are used up),
// within 1e-3 and 2e-4/mm where it varies, or there are 400 of them; then `most` is what was reached, however
// wide. The last thousandth of a facet beside a pole of its surface is left out: a parametrisation says
// nothing there. `constant`: the curvature of the face where it is one (rolled_balls), else 0.
SharpestPoint sharpest_point(const BrepView& brep, const FacetOrigin& facet, const FacetDomain& domain,
                             double constant = 0);

}  // namespace gabarit
