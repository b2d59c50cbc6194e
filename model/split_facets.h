// Facets of exact surfaces cut until none has a side longer than wanted, without opening the mesh.
#pragma once

#include <cstdint>

#include "model/brep.h"
#include "model/triangle_mesh.h"

namespace gabarit {

// Halves every side of facets [first, end of the mesh) that is longer than `longest`, again and again. New
// vertices lie on the surface of their face, those between two faces on the curve of their edge; both
// neighbours of a side get the same vertex. The facets are those of whole bodies: none of them shares a side
// with facets before `first`. Returns false, and leaves sides longer, when there would be more than `most`
// facets.
bool split_facets(const Brep& brep, double longest, std::uint64_t most, FacetId first, TriangleMesh& mesh,
                  std::vector<FacetOrigin>& origins);

}  // namespace gabarit
