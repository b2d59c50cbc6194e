// The point of the facets nearest to a given one.
#pragma once

#include <span>

#include "gpu/bvh.h"

namespace gabarit {

struct ClosestPoint {
  double distance = std::numeric_limits<double>::infinity();
  Vec3d point;
  std::uint32_t facet = no_child;  // none: the tree holds no facets
};

// Of equally near facets the one with the smallest id is given.
void closest_points(const Bvh& tree, std::span<const Vec3d> points, std::span<ClosestPoint> closest);

}  // namespace gabarit
