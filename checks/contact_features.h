// The edges and vertices that a ball can touch without touching a facet: reflex ones for a ball in the
// material (a rib root, the tip of a groove), sharp ones for a ball outside.
#pragma once

#include <span>

#include "checks/contact_surface.h"

namespace gabarit {

// Adds edges whose facets bend by more than 8 degrees towards the ball, and the vertices at their ends, after
// the facets of `surface`. Flatter ones say nothing that their facets do not say. `normals` and `sag`: of the
// facets.
void add_features(FacetSurface& surface, const TriangleMesh& mesh, std::span<const Vec3d> normals,
                  const Adjacency& adjacency, const std::vector<float>& sag, Side side);

}  // namespace gabarit
