// Which pieces of a disk's path hang together, and which of them a disk from outside can get to.
#pragma once

#include "checks/disk_path.h"

namespace gabarit {

// Numbers the components of `pieces` (PathPiece::component) and says of each whether the free space beside it
// is connected to infinity. Free space is connected across an island by a ray from the island's rightmost
// point to the next component it meets.
std::vector<bool> number_components(std::vector<PathPiece>& pieces, double radius);

}  // namespace gabarit
