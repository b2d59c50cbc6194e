#include "gpu/device.h"

#include <algorithm>

#include "gpu/qualifiers.h"

namespace gabarit {

static VectorSet widest() {
#if GABARIT_X86
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq"))
    return VectorSet::avx512;
  if (__builtin_cpu_supports("avx2")) return VectorSet::avx2;
#endif
  return VectorSet::portable;
}

VectorSet available(VectorSet wanted) { return std::min(wanted, widest()); }

}  // namespace gabarit
