// Random points of a model's trimmed faces: what no ball that was found may hold.
#pragma once

#include <vector>

#include "model/brep.h"

namespace gabarit {

struct BoundaryPoint {
  Vec3d p, normal;  // outward
};

// `tries` a face over its range; those outside the trimming curves are left out.
std::vector<BoundaryPoint> dense_boundary(const Brep& brep, std::size_t tries);

}  // namespace gabarit
