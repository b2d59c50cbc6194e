// Which of eight floats are no greater than a limit, as bits: the one step of a walk for which compilers do
// not find the instruction in a loop.
#pragma once

#include "gpu/device.h"
#include "gpu/qualifiers.h"

#if GABARIT_X86 && !GABARIT_ON_GPU
#include <immintrin.h>
#endif

namespace gabarit {

struct alignas(32) EightFloats {
  float at[8];
  GABARIT_HD float& operator[](int i) { return at[i]; }
  GABARIT_HD float operator[](int i) const { return at[i]; }
};

#if GABARIT_X86 && !GABARIT_ON_GPU
__attribute__((target("avx512f,avx512vl,avx512dq"))) inline unsigned no_greater_avx512(const EightFloats& x,
                                                                                       float limit) {
  return _mm256_cmp_ps_mask(_mm256_load_ps(x.at), _mm256_set1_ps(limit), _CMP_LE_OQ);
}
__attribute__((target("avx2"))) inline unsigned no_greater_avx2(const EightFloats& x, float limit) {
  return static_cast<unsigned>(
      _mm256_movemask_ps(_mm256_cmp_ps(_mm256_load_ps(x.at), _mm256_set1_ps(limit), _CMP_LE_OQ)));
}
#endif

// Only for code that runs when these vector instructions are there.
template <VectorSet set>
GABARIT_HD inline unsigned no_greater(const EightFloats& x, float limit) {
#if GABARIT_X86 && !GABARIT_ON_GPU
  if constexpr (set == VectorSet::avx512) return no_greater_avx512(x, limit);
  if constexpr (set == VectorSet::avx2) return no_greater_avx2(x, limit);
#endif
  unsigned mask = 0;
  for (int i = 0; i < 8; ++i) mask |= x[i] <= limit ? 1U << i : 0U;
  return mask;
}

}  // namespace gabarit
