// The radius of convex rounding by balls placed inside (Inui and Umezu, Extraction of Vertical Cylinder
// Contacting Area for Motorcycle Safety Verification, 2.2).
#pragma once

#include "checks/check.h"

namespace gabarit {

// The largest ball that touches a facet from inside at its centroid and meets no facet that shares an edge
// segment with it: infinite when none is in the way. The paper asks whether one ball of the limit's radius
// fits; this is the radius at which the answer changes. The bounds are equal to the value: they are those of
// this definition, not of the surface that the facets were cut from.
Field measure_sphere_placement(const Scene& scene, const Setup& setup, const Region& region);

}  // namespace gabarit
