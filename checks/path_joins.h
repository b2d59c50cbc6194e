// Whether two pieces of a disk's path meet.
#pragma once

#include "checks/disk_path.h"

namespace gabarit {

double distance(const PathPiece& piece, double radius, Point2 p);

// An end of one lies on the other, or their insides touch or cross; all to within `near`.
bool meet(const PathPiece& a, const PathPiece& b, double radius, double near);

}  // namespace gabarit
