// The radius of convex rounding from how much the surface turns at the edges of its facets.
#pragma once

#include "checks/check.h"

namespace gabarit {

Field measure_turning(const Scene& scene, const Setup& setup, const Region& region);

}  // namespace gabarit
