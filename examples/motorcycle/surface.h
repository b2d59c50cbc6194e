// The true surface of a closed solid, as a function of two parameters.
#pragma once

#include <functional>
#include <vector>

#include "gpu/vec3.h"

namespace gabarit::motorcycle {

// `at(u, v)` is closed in v: the last of `v_breaks` is the first again. In u it ends in two points (its value
// does not depend on v there) or, as a ring does, meets itself. Between neighbouring breaks the surface is
// smooth; a crease lies on a break. Millimetres.
struct Surface {
  std::function<Vec3d(double u, double v)> at;
  std::vector<double> u_breaks, v_breaks;
  bool smooth_u = false, smooth_v = false;  // across the (evenly spaced) breaks too, as splines are
  bool ring = false;                        // closed in u too
  bool flipped = false;                     // the outward normal is -(du × dv) instead of du × dv
};

// From the coordinates in which a part is drawn to the vehicle's; keeps orientation.
using Placement = std::function<Vec3d(const Vec3d&)>;

// The same solid on the other side of the median plane (y = 0).
Surface mirrored(const Surface& surface);

}  // namespace gabarit::motorcycle
