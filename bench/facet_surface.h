// Facets, trees and queries of a mesh as the paper has them: every facet counts, facet normals, one query a
// facet.
#pragma once

#include <algorithm>
#include <vector>

#include "gpu/maximal_sphere.h"
#include "model/triangle_mesh.h"

namespace gabarit {

FacetSurface facet_surface(const TriangleMesh& mesh);

// From the middles of the facets inwards, in the order of the tree.
std::vector<SphereQuery> inward_queries(const TriangleMesh& mesh, const Bvh& tree);

// No separation, contacts nearer than 1e-6 of the model's size are none.
SphereOptions paper_definition(const TriangleMesh& mesh);

double processor_seconds();

template <class Work>
double seconds_of(Work&& work) {
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}

// The least of three runs: other programs only make it slower.
template <class Work>
double least_seconds_of(Work&& work) {
  double least = seconds_of(work);
  for (int run = 1; run < 3; ++run) least = std::min(least, seconds_of(work));
  return least;
}

}  // namespace gabarit
