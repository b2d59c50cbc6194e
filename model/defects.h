// What is wrong with a mesh, counted; nothing is repaired.
#pragma once

#include <cstdint>

#include "model/triangle_mesh.h"

namespace gabarit {

struct Defects {
  std::uint64_t not_finite = 0;  // facets with a NaN or infinite coordinate
  std::uint64_t degenerate = 0;  // finite facets without a normal (no area)
  std::uint64_t duplicate = 0;   // facets over the same three vertices as an earlier one, in any order
  std::uint64_t open_edges = 0;  // edges of one facet
  std::uint64_t non_manifold_edges = 0;  // edges of three facets or more
  std::uint64_t misoriented_edges = 0;   // edges of two facets that run the same way round

  friend bool operator==(const Defects&, const Defects&) = default;
};

// Linear in the facets; degenerate and non-finite facets do not take part in the edge counts.
Defects count_defects(const TriangleMesh& mesh);

inline bool watertight(const Defects& d) {
  return d.not_finite == 0 && d.open_edges == 0 && d.non_manifold_edges == 0 && d.misoriented_edges == 0;
}

}  // namespace gabarit
