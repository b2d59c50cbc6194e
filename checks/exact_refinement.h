// The least wall of a facet, looked for on its exact surface between the places that were sampled.
#pragma once

#include "checks/exact_probe.h"

namespace gabarit {

struct RefineOptions {
  double limit = 0;         // mm; 0: only the facets near the least value of all are looked at
  bool facets_bind = true;  // values that the facets' own bounds exclude are not taken
};

// Of facets that the limit lies between the bounds of, and of those that read less than their neighbours
// among the thin ones: a grid of fifteen places on the facet and a descent from the best of them, until a
// step is less than 2e-5 mm. Then the value, its place and its upper bound are those of the least place; the
// lower bound follows where every ball or ray on the way was verified. Places whose rays shrink towards an
// edge are left out, and then the lower bound stays.
void refine_least(Field& field, const Scene& scene, const ExactMeasure& walls, const RefineOptions& options);

}  // namespace gabarit
