// Normals of the surface that the facets stand for, at the corners of every facet.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "gpu/device.h"
#include "model/triangle_mesh.h"

namespace gabarit {

// At each corner the mean of the facets around the vertex that are within the crease angle (radians) of the
// facet itself, weighted by area times the angle at the corner: a split quad counts like a whole one, and a
// large plane keeps its direction where a fillet begins. Unit vectors; zero where the facet has no normal.
// `normals`: those of the facets.
std::vector<std::array<Vec3f, 3>> smooth_normals(const TriangleMesh& mesh, std::span<const Vec3d> normals,
                                                 double crease, const Device& device);

}  // namespace gabarit
