// Facets so thin that the rounding of their corners turns their normal at will; every CAD export has some.
#pragma once

#include <vector>

#include "model/adjacency.h"

namespace gabarit {

// How far a coordinate of this point can be off when it was stored as a float, mm.
double coordinate_rounding(const Vec3d& p);

// Whether rounding can turn the facet's normal by more than 0.02 rad.
bool is_sliver(const TriangleMesh& mesh, FacetId f);

// The facets across the edges of f, looking over slivers: in place of a sliver stand the facets across its
// other long edges. Needs the adjacency of the slivers too; appends to `out`.
void neighbours_over_slivers(const TriangleMesh& mesh, const Adjacency& adjacency, FacetId f,
                             std::vector<EdgeNeighbour>& out);

}  // namespace gabarit
