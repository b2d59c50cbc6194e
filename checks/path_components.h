// Which pieces of a disk's path hang together, and which of them the disk reaches from far away.
#pragma once

#include <vector>

#include "checks/disk_path.h"

namespace gabarit {

// Numbers the components of the path's pieces; says of each whether it is connected to infinity. Two free
// places nearer than d to each other count as joined: the midpoint between them is free for a disk whose
// radius is smaller by d² / 8R, which is made less than the rounding of the coordinates.
std::vector<bool> number_components(std::vector<PathPiece>& pieces, const OutlineFeatures& outline,
                                    double radius);

}  // namespace gabarit
