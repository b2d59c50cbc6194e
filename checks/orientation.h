// Bodies whose facets look inwards.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/device.h"
#include "model/triangle_mesh.h"

namespace gabarit {

// Numbers of the bodies that enclose a negative volume, ascending. Only of bodies whose facets' areas add up
// to nothing, as those of a closed surface do; an open one has no inside to tell.
std::vector<std::uint32_t> inside_out_bodies(const TriangleMesh& mesh, const Device& device);

}  // namespace gabarit
