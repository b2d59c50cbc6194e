// The curvature of the surface that a facet and its neighbours were cut from, from the turning at their
// edges.
#pragma once

#include "checks/folds.h"

namespace gabarit {

struct CurvatureFit {
  double curvature = 0;   // the largest normal curvature, convex positive, 1/mm
  double doubt = 0;       // by how much the edges disagree with it, 1/mm; infinite: nothing was fitted
  double steepest = 0;    // the largest turn at an edge over the mean height of its facets, 1/mm
  bool resolved = false;  // some edge turns with turning beyond both its sides: more than one strip of facets
};

// A surface z = ½ xᵀHx through the corners of two facets that share an edge turns at the edge by tr(H M) with
// M from the shape of the two facets alone (see docs/radius.md); exact to second order for any triangles
// whose corners lie on the surface. H is fitted by least squares to the edges of the facet and of its
// neighbours. Sides of an edge on which the surface does not turn on are planes: H = 0 there. Concave edges
// are left out when the others agree better without them.
CurvatureFit fit_curvature(const TriangleMesh& mesh, const Folds& folds, FacetId f);

}  // namespace gabarit
