// Numbers for what was counted in parallel.
#pragma once

#include <cstdint>

#include "gpu/buffer.h"

namespace gabarit {

struct PrefixSums {
  Buffer<std::uint32_t> before;  // by element: the sum of those before it
  std::uint32_t total = 0;       // of all; must stay below 2^32
};

PrefixSums prefix_sums(const Device& device, const Buffer<std::uint32_t>& counts);

}  // namespace gabarit
