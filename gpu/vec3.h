// A point or direction in space; plain data, the same layout on every device.
#pragma once

#include <cmath>

#include "gpu/qualifiers.h"

namespace gabarit {

template <class T>
struct Vec3 {
  T x{}, y{}, z{};

  GABARIT_HD constexpr T operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  GABARIT_HD constexpr T& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  GABARIT_HD constexpr Vec3& operator+=(const Vec3& b) { return x += b.x, y += b.y, z += b.z, *this; }
  GABARIT_HD constexpr Vec3& operator-=(const Vec3& b) { return x -= b.x, y -= b.y, z -= b.z, *this; }
  GABARIT_HD constexpr Vec3& operator*=(T s) { return x *= s, y *= s, z *= s, *this; }
  GABARIT_HD friend constexpr Vec3 operator+(Vec3 a, const Vec3& b) { return a += b; }
  GABARIT_HD friend constexpr Vec3 operator-(Vec3 a, const Vec3& b) { return a -= b; }
  GABARIT_HD friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  GABARIT_HD friend constexpr Vec3 operator*(Vec3 a, T s) { return a *= s; }
  GABARIT_HD friend constexpr Vec3 operator*(T s, Vec3 a) { return a *= s; }
  GABARIT_HD friend constexpr Vec3 operator/(Vec3 a, T s) { return {a.x / s, a.y / s, a.z / s}; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

using Vec3d = Vec3<double>;
using Vec3f = Vec3<float>;

template <class T>
GABARIT_HD constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
GABARIT_HD constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
GABARIT_HD constexpr T squared_length(const Vec3<T>& a) {
  return dot(a, a);
}
template <class T>
GABARIT_HD T length(const Vec3<T>& a) {
  return std::sqrt(dot(a, a));
}
// The zero vector stays zero.
template <class T>
GABARIT_HD Vec3<T> normalized(const Vec3<T>& a) {
  const T l = length(a);
  return l > T(0) ? a / l : Vec3<T>{};
}
template <class T>
GABARIT_HD constexpr Vec3<T> min(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
}
template <class T>
GABARIT_HD constexpr Vec3<T> max(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}
inline bool is_finite(const Vec3d& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace gabarit
