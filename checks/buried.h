// Facets that lie inside the part, where the mesh overlaps itself: they bound no wall.
#pragma once

#include "checks/facet_cells.h"

namespace gabarit {

// Answers like `probe`, but a place that reads less than `doubt` (mm) and from which a ray outwards first
// leaves the part is `buried`: it has no value, and what it reads is a lower bound, as material of several
// bodies is no thinner than that of one. Bodies that touch without overlapping are not buried in each other.
Probe set_buried_aside(Probe probe, const ContactSurface& surface, double doubt);

}  // namespace gabarit
