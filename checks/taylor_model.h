// Polynomials over a box with a bound of what they leave out: the values of a function over the whole box.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace gabarit {

constexpr int taylor_order = 5;
constexpr int taylor_terms = (taylor_order + 1) * (taylor_order + 2) / 2;
constexpr double unit_roundoff = 0x1p-53;

// The place of x^i y^j: by total degree.
constexpr int taylor_term(int i, int j) { return (i + j) * (i + j + 1) / 2 + j; }

// A function f of (x, y) in [-1, 1]² with |f - Σ c_ij x^i y^j| <= r everywhere (Makino & Berz, Taylor Models
// and Other Validated Functional Inclusion Methods, 2003). Every operation adds what it cuts off and what it
// rounds off to r: the rounding of a sum of n products by n + 2 unit roundoffs of the sum of their sizes,
// that of r itself by a relative 1e-14. Where an operation is not defined over the whole box r is infinite or
// NaN.
struct TaylorModel {
  std::array<double, taylor_terms> c{};
  double r = 0;
};

inline TaylorModel constant(double value) {
  TaylorModel m;
  m.c[0] = value;
  return m;
}
inline TaylorModel unbounded() { return {{}, std::numeric_limits<double>::infinity()}; }

inline double outward(double r) { return r * (1 + 1e-14); }

// Σ |c_ij| by total degree.
using TaylorNorms = std::array<double, taylor_order + 1>;
inline TaylorNorms norms(const TaylorModel& a) {
  TaylorNorms n{};
  for (int m = 0, t = 0; m <= taylor_order; ++m) {
    for (int i = 0; i <= m; ++i, ++t)
      n[static_cast<std::size_t>(m)] += std::fabs(a.c[static_cast<std::size_t>(t)]);
  }
  return n;
}
inline double norm(const TaylorModel& a) {
  double sum = 0;
  for (const double c : a.c) sum += std::fabs(c);
  return sum;
}

inline TaylorModel operator+(const TaylorModel& a, const TaylorModel& b) {
  TaylorModel s;
  for (std::size_t i = 0; i < s.c.size(); ++i) s.c[i] = a.c[i] + b.c[i];
  s.r = outward(a.r + b.r + unit_roundoff * norm(s));
  return s;
}
inline TaylorModel operator-(const TaylorModel& a, const TaylorModel& b) {
  TaylorModel s;
  for (std::size_t i = 0; i < s.c.size(); ++i) s.c[i] = a.c[i] - b.c[i];
  s.r = outward(a.r + b.r + unit_roundoff * norm(s));
  return s;
}
inline TaylorModel operator*(const TaylorModel& a, double by) {
  TaylorModel s;
  for (std::size_t i = 0; i < s.c.size(); ++i) s.c[i] = a.c[i] * by;
  s.r = outward(a.r * std::fabs(by) + unit_roundoff * norm(s));
  return s;
}
TaylorModel operator*(const TaylorModel& a, const TaylorModel& b);

// a to the power of -1, -1/2 or 1/2; unbounded where a may vanish, or nearly so.
TaylorModel power(const TaylorModel& a, double exponent);

struct TaylorPlace {
  double x, y;
};
// Bounds of the values: over the convex hull of places, to about a hair beyond them; of the size, everywhere.
double greatest(const TaylorModel& a, std::span<const TaylorPlace> hull);
double greatest_size(const TaylorModel& a);

struct TaylorVector {
  TaylorModel x, y, z;
};
inline TaylorVector operator+(const TaylorVector& a, const TaylorVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline TaylorVector operator-(const TaylorVector& a, const TaylorVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline TaylorVector operator*(const TaylorVector& a, const TaylorModel& by) {
  return {a.x * by, a.y * by, a.z * by};
}
inline TaylorModel dot(const TaylorVector& a, const TaylorVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline TaylorVector cross(const TaylorVector& a, const TaylorVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace gabarit
