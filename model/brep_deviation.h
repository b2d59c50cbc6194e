// How facets lie on the surfaces of a Brep, and how far from them.
#pragma once

#include "model/brep.h"
#include "model/triangle_mesh.h"

namespace gabarit {

// At a pole or an apex one parameter means nothing, and the tessellation's own may be anything. This notes
// which corner that is and sets the parameter to the mean of the other two corners'. Corners that files put a
// hair beyond the surface's own ends are brought back.
void settle_poles(const Brep& brep, FacetOrigin& facet);

// mm: the greatest distance between the surface and its facets, over ten points a facet of
// [first, last). The greatest distance between the points is at most a tenth larger where the surface is
// close to a parabola within a facet. Faces that are not on a facet (origin without face) do not count.
double greatest_deviation(const Brep& brep, const TriangleMesh& mesh, FacetId first, FacetId last);

}  // namespace gabarit
