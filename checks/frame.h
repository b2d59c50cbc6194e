// How the model stands: which way is up and forward, and where the ground is.
#pragma once

#include <optional>

#include "gpu/box.h"
#include "gpu/plan_axes.h"
#include "gpu/vec3.h"

namespace gabarit {

// An axis-parallel direction: a row of the rotation, exact.
struct Frame {
  Vec3d up{0, 0, 1};
  Vec3d forward{-1, 0, 0};
  double ground = 0;  // height of the ground along `up`, mm

  Vec3d left() const { return cross(up, forward); }
  double height(const Vec3d& p) const { return dot(p, up) - ground; }
  // Vehicle coordinates (ISO 4130): x rearward, z up, right-handed (y to the right of the driver), z = 0 on
  // the ground.
  Vec3d to_vehicle(const Vec3d& p) const { return plan_axes()(p); }
  PlanAxes plan_axes() const { return {forward, left(), up, ground}; }
  Vec3d direction_to_vehicle(const Vec3d& d) const { return {-dot(d, forward), -dot(d, left()), dot(d, up)}; }
  Vec3d from_vehicle(const Vec3d& q) const { return up * (q.z + ground) - forward * q.x - left() * q.y; }
};

}  // namespace gabarit
