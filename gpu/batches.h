// Work that does not fit into the memory of a device at once is done in smaller batches.
#pragma once

#include <algorithm>
#include <cstdint>

#include "gpu/device_error.h"

namespace gabarit {

// Calls work(begin, end) for runs that cover [0, n) in order. A run that throws OutOfDeviceMemory is halved,
// and so are those after it; runs begin at multiples of `unit`, and when one unit does not fit the exception
// is let through. Work that is thrown out of is begun again.
template <class Work>
void in_batches(std::int64_t n, std::int64_t unit, Work&& work) {
  std::int64_t size = (n + unit - 1) / unit * unit;
  for (std::int64_t begin = 0; begin < n;) {
    const std::int64_t end = std::min(begin + size, n);
    try {
      work(begin, end);
      begin = end;
    } catch (const OutOfDeviceMemory&) {
      const std::int64_t units = (end - begin + unit - 1) / unit;
      if (units <= 1) throw;
      size = (units + 1) / 2 * unit;
    }
  }
}

}  // namespace gabarit
