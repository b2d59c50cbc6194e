// Cuts a polygon to a rectangle of the page.
#pragma once

#include <vector>

#include "gpu/vec3.h"

namespace gabarit {

// By x, then y, then z.
inline bool in_order(const Vec3d& a, const Vec3d& b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

// The part of a convex polygon with left <= x <= right and top <= y <= bottom (Sutherland & Hodgman 1974); z
// goes along. Empty when nothing is left.
std::vector<Vec3d> clipped(std::vector<Vec3d> polygon, double left, double top, double right, double bottom);

}  // namespace gabarit
