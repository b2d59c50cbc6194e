// What several threads may do to one place of memory at the same time. Results that depend on who comes first
// must not leave a kernel.
#pragma once

#include <bit>
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
GABARIT_HD inline void add_shared(std::int64_t& place, std::int64_t value) {
#if GABARIT_ON_GPU
  atomicAdd(reinterpret_cast<unsigned long long*>(&place), static_cast<unsigned long long>(value));
#else
  __atomic_fetch_add(&place, value, __ATOMIC_RELAXED);
#endif
}

// Leaves the smaller one there. The place is looked at first: it is seldom lowered.
GABARIT_HD inline void lower_shared(std::uint32_t& place, std::uint32_t value) {
#if GABARIT_ON_GPU
  if (static_cast<volatile std::uint32_t&>(place) > value) atomicMin(&place, value);
#else
  std::uint32_t now = __atomic_load_n(&place, __ATOMIC_RELAXED);
  while (value < now &&
         !__atomic_compare_exchange_n(&place, &now, value, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
  }
#endif
}

// Floats by their order as unsigned numbers, of which one can be the least of many; no NaN.
GABARIT_HD inline std::uint32_t ordered(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x + 0.0F);  // one zero
  return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}
GABARIT_HD inline float from_ordered(std::uint32_t order) {
  return std::bit_cast<float>((order & 0x80000000U) != 0 ? order & 0x7fffffffU : ~order);
}

}  // namespace gabarit
