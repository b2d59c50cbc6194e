// The sides of the projected facets that a column from outside can possibly touch.
#pragma once

#include <vector>

#include "checks/outline_features.h"
#include "checks/reach_grid.h"

namespace gabarit {

// All sides of every facet that `grid` cannot rule out, facet by facet in ascending order. Turns are exact.
std::vector<PlanSide> reachable_sides(const PlanProjection& plan, const ReachGrid& grid);

}  // namespace gabarit
