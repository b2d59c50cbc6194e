// The facets around a region, and who is next to whom among them.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "checks/scene.h"

namespace gabarit {

struct Surroundings {
  std::vector<FacetId> facets;  // ascending
  std::shared_ptr<const Adjacency> adjacency;
};

// All facets within `rings` edges of those given, T-junctions included, and some more; the whole mesh when
// that is quicker.
Surroundings surroundings(const Scene& scene, std::span<const FacetId> facets, int rings);

}  // namespace gabarit
