// What a plane cuts out of a model: the outline of the cut, and where along a line through it there is
// material.
#pragma once

#include <optional>
#include <vector>

#include "report/camera.h"

namespace gabarit {

// Of the outline, seen against the camera: the material lies on its left.
struct SectionEdge {
  PagePoint from, to;  // mm, see project()
};

using Section = std::vector<SectionEdge>;

// By the plane through the camera's target that it looks at squarely; one edge for every facet that the plane
// meets, in the order of the facets. A vertex in the plane counts as in front of it, so a closed mesh has a
// closed outline; facets in the plane and facets that are not finite have no edge.
Section cut(const TriangleMesh& mesh, const Camera& camera);

// Where a line is in the material, as distances from `start` along the unit direction; ascending. None when
// the line leaves the outline in another state than it came: the mesh is open there.
struct Stretch {
  double from = 0, to = 0;
};
std::optional<std::vector<Stretch>> material_along(const Section& section, PagePoint start,
                                                   PagePoint direction);

}  // namespace gabarit
