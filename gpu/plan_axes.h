// How a mesh stands in its plan.
#pragma once

#include "gpu/vec3.h"

namespace gabarit {

// Three unit vectors at right angles to each other, and the height of the ground along `up`, mm.
struct PlanAxes {
  Vec3d forward{-1, 0, 0}, left{0, -1, 0}, up{0, 0, 1};
  double ground = 0;

  // To x rearward, y to the right, z above the ground.
  GABARIT_HD Vec3d operator()(const Vec3d& p) const {
    return {-dot(p, forward), -dot(p, left), dot(p, up) - ground};
  }
};

}  // namespace gabarit
