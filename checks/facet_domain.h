// The parameters that a facet stands for: nothing of its face lies between facets.
#pragma once

#include <vector>

#include "model/brep_view.h"
#include "model/edge_table.h"

namespace gabarit {

struct FacetDomain {
  ParameterBox box;  // holds the triangle of the corners, and what of the face lies beyond its curved sides
  // Whether nothing of it lies beyond the side from corner k to corner k + 1.
  std::array<bool, 3> straight{};
};

// The facets of a face tile the polygon of its corners in the plane of parameters. Between two corners on a
// trimming curve the face itself reaches to the curve. Its pieces run one way in u and in v, so that the
// piece between the corners lies in the box of their places on it, and one that turns between them, in the
// box of these and the turning point. A side at which neither is found widens the box by its own size to all
// sides. Corners count as lying on a piece within a hundredth of the facet's box. Beside a pole the domain is
// the box. `other` is the half-edge (3 · facet + side) on the other side of h, h itself at free edges.
FacetDomain facet_domain(const Brep& brep, FacetId facet, const std::array<HalfEdgeId, 3>& other);

// Whether the point is in the triangle of the corners, or a hair beside it.
bool in_triangle(const FacetOrigin& facet, Parameters p);

// What of the box does not lie beyond a straight side: a convex polygon that holds the part of the domain in
// the box, empty when there is none. A hair wider than the triangle, whatever is rounded.
std::vector<Parameters> part_in(const FacetOrigin& facet, const FacetDomain& domain, const ParameterBox& box);

}  // namespace gabarit
