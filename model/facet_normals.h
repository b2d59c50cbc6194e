// The normals of all facets, for whoever looks at each more than once.
#pragma once

#include <vector>

#include "gpu/device.h"
#include "model/triangle_mesh.h"

namespace gabarit {

// facet_normal of each. The same on any number of threads.
std::vector<Vec3d> facet_normals(const TriangleMesh& mesh, const Device& device);

}  // namespace gabarit
