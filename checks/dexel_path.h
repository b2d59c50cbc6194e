// Places of the path of a rolling disk, from dexels.
#pragma once

#include "checks/disk_path.h"

namespace gabarit {

// Pieces of no length: the ends of the dexels of the outline's offset, on lines along x and along y that are
// `spacing` apart, where they border on places that are connected to infinity. Gaps between dexels that touch
// the same square of the grid count as connected. So
// - all that the disk reaches is found: from every place of its path there is one of these within a square's
//   diagonal;
// - all of these are reached by a disk whose radius is smaller by half of that diagonal.
// The spacing must be less than half of the radius. Throws std::invalid_argument when a direction needs more
// than 100 000 lines.
DiskPath dexel_path(const OutlineFeatures& outline, double radius, double spacing, const Device& device);

}  // namespace gabarit
