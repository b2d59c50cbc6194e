// Cuts polygons into triangles.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "gpu/vec3.h"

namespace gabarit {

// Corner numbers of n - 2 triangles that cover a simple polygon, concave or not, with its orientation (ear
// clipping in the plane of its mean normal). A polygon that crosses itself still gives n - 2 triangles.
std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec3d> polygon);

}  // namespace gabarit
