// A sum of unit vectors that does not depend on the order in which they are added.
#pragma once

#include "gpu/atomic.h"
#include "gpu/vec3.h"

namespace gabarit {

// In whole steps of 2^-32, of fewer than 2^31 vectors.
struct NormalSum {
  std::int64_t sum[3] = {};

  GABARIT_HD static std::int64_t steps(float x) { return static_cast<std::int64_t>(x * 4294967296.0F); }
  GABARIT_HD void add(const Vec3f& v) {
    for (int k = 0; k < 3; ++k) sum[k] += steps(v[k]);
  }
  GABARIT_HD void add_shared(const Vec3f& v) {
    for (int k = 0; k < 3; ++k) gabarit::add_shared(sum[k], steps(v[k]));
  }
  GABARIT_HD Vec3d value() const {
    constexpr double step = 1 / 4294967296.0;
    return {static_cast<double>(sum[0]) * step, static_cast<double>(sum[1]) * step,
            static_cast<double>(sum[2]) * step};
  }
};

}  // namespace gabarit
