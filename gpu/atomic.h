// What several threads may do to one place of memory at the same time. Results that depend on who comes first
// must not leave a kernel.
#pragma once

#include <cstdint>

#include "gpu/qualifiers.h"

namespace gabarit {

// All that write at once write the same.
GABARIT_HD inline void store_shared(std::uint8_t& place, std::uint8_t value) {
#if GABARIT_ON_GPU
  static_cast<volatile std::uint8_t&>(place) = value;
#else
  // Looking first keeps the cache line shared where it is set already.
  if (__atomic_load_n(&place, __ATOMIC_RELAXED) != value) __atomic_store_n(&place, value, __ATOMIC_RELAXED);
#endif
}

// The value before.
GABARIT_HD inline std::uint32_t fetch_add(std::uint32_t& place, std::uint32_t value) {
#if GABARIT_ON_GPU
  return atomicAdd(&place, value);
#else
  return __atomic_fetch_add(&place, value, __ATOMIC_RELAXED);
#endif
}

}  // namespace gabarit
