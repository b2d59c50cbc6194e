// An axis-parallel box; empty until something is put in.
#pragma once

#include <limits>

#include "gpu/vec3.h"

namespace gabarit {

template <class T>
struct Box {
  Vec3<T> min{std::numeric_limits<T>::infinity(), std::numeric_limits<T>::infinity(),
              std::numeric_limits<T>::infinity()};
  Vec3<T> max{-std::numeric_limits<T>::infinity(), -std::numeric_limits<T>::infinity(),
              -std::numeric_limits<T>::infinity()};

  GABARIT_HD constexpr bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  GABARIT_HD constexpr void add(const Vec3<T>& p) {
    min = gabarit::min(min, p);
    max = gabarit::max(max, p);
  }
  GABARIT_HD constexpr void add(const Box& b) {
    min = gabarit::min(min, b.min);
    max = gabarit::max(max, b.max);
  }
  GABARIT_HD constexpr Vec3<T> extent() const { return empty() ? Vec3<T>{} : max - min; }
  GABARIT_HD constexpr Vec3<T> centre() const { return (min + max) * T(0.5); }
};

using Box3d = Box<double>;
using Box3f = Box<float>;

}  // namespace gabarit
