// Facets without height, which tessellations of cones leave at the apex.
#pragma once

#include <cstdint>

#include "model/brep.h"
#include "model/triangle_mesh.h"

namespace gabarit {

// Flips the longest edge of every facet of [first, last) that is less than 1e-6 mm high, when its neighbour
// there lies on the same face and both facets become higher. The surface moves by less than 1e-6 mm, the
// number of facets and all edges along faces stay. Returns how many were flipped.
std::uint64_t flip_collapsed_facets(TriangleMesh& mesh, std::vector<FacetOrigin>& origins, FacetId first,
                                    FacetId last);

}  // namespace gabarit
