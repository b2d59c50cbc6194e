// Connected patches of failing and of undecided facets.
#pragma once

#include "rules/outcome.h"

namespace gabarit {

struct Findings {
  std::vector<Finding> listed;  // fails, worst first, then undecided ones, worst first; numbered from 1
  std::size_t ignored = 0;      // smaller than the rule's ignore_area
};

// Facets belong together when they share an edge segment (T-junctions included) and a verdict; facets that
// only meet at a corner do not. The order is by excess over the limit, then area, then facet: the same for
// the same input.
Findings find_patches(const Model& model, const Rule& rule, const Field& field,
                      const std::vector<FacetVerdict>& verdicts);

}  // namespace gabarit
