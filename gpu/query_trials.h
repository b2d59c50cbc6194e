// Every kind of work of this layer on one surface, to compare devices and to time them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "gpu/bvh.h"

namespace gabarit {

// Ready to be done; may be done again.
struct PreparedTrial {
  std::function<void()> run;
  std::function<std::vector<std::uint64_t>()> bits;  // of all answers of the last run
};

struct QueryTrial {
  const char* name;  // such as "rays"
  // The surface, facets only, must outlive what is prepared.
  PreparedTrial (*prepare)(const Device& device, const FacetSurface& surface);
};

std::span<const QueryTrial> query_trials();

}  // namespace gabarit
