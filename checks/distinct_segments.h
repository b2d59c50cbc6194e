// Segments that lie on each other end for end, once.
#pragma once

#include <cstdint>
#include <vector>

#include "checks/outline_features.h"
#include "gpu/segment_grid.h"

namespace gabarit {

struct DistinctSegments {
  std::vector<Segment2> segments;     // in the order of first appearance
  std::vector<std::uint32_t> number;  // by side
};

// Whichever way the sides run: two facets share most of them, and upright walls project to the same again and
// again.
DistinctSegments distinct_segments(const std::vector<PlanSide>& sides);

}  // namespace gabarit
