// The sides of facets in plan.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/plan_facets.h"

namespace gabarit {

// A side of a projected facet, and where it comes from.
struct PlanSide {
  Point2 from, to;
  std::uint32_t facet;
  std::uint8_t edge;  // of the facet; 3: where the height band cuts it
  int turn;  // 1: the rest of the facet lies left of the side, -1: right, 0: it projects to the side itself
};

// For a turn that rounding may have decided.
constexpr int doubtful_turn = 2;

// All sides of what the band leaves of these facets, facet by facet in the order given. A turn is either
// certain or doubtful. What does not fit at once is found in batches. Throws DeviceError and
// OutOfDeviceMemory.
std::vector<PlanSide> plan_sides(const PlanFacets& plan, std::span<const std::uint32_t> facets);

}  // namespace gabarit
