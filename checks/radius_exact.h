// The radius of convex rounding, read from exact surfaces.
#pragma once

#include "checks/check.h"

namespace gabarit {

// For models with a B-Rep. The radius of a facet is that of the sharpest point of its part of the face, or 0
// when one of its selected edges is sharp: the outward normals of the two faces turn by more than 5 degrees
// there, away from each other. Radii are rounded to 1e-6 mm, which is more than what a file's numbers carry;
// lower and upper bound equal the value, but on splines, extrusions and revolutions whose curvature varies
// within a facet: there the lower bound is proven for all that the facet stands for (docs/radius.md). Facets
// at the free edge of an open surface have the lower bound 0.
Field measure_exact_radius(const Scene& scene, const Region& region);

}  // namespace gabarit
