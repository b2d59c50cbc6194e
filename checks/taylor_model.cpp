#include "checks/taylor_model.h"

#include <algorithm>
#include <utility>

namespace gabarit {
namespace {

constexpr auto at(int t) { return static_cast<std::size_t>(t); }

double sum_of(const TaylorNorms& n) {
  double sum = 0;
  for (const double d : n) sum += d;
  return sum;
}

// What lies beyond the order in a product of the polynomials.
double cut_off(const TaylorNorms& a, const TaylorNorms& b) {
  double sum = 0, tail = 0;
  for (int m = 1; m <= taylor_order; ++m) {
    tail += b[at(taylor_order + 1 - m)];
    sum += a[at(m)] * tail;
  }
  return sum;
}

// The terms of total degree m of one times those of total degree n of the other. The loops have constant
// bounds, so that nothing of them is left: a product costs a fifth.
template <int m, int n>
void add_products(const TaylorModel& a, const TaylorModel& b, TaylorModel& sum) {
#pragma GCC unroll 6
  for (int i = 0; i <= m; ++i) {
#pragma GCC unroll 6
    for (int j = 0; j <= n; ++j)
      sum.c[at(taylor_term(m + n, 0) + i + j)] +=
          a.c[at(taylor_term(m, 0) + i)] * b.c[at(taylor_term(n, 0) + j)];
  }
}

template <int m, int... n>
void add_degree(const TaylorModel& a, const TaylorModel& b, TaylorModel& sum,
                std::integer_sequence<int, n...>) {
  (add_products<m, n>(a, b, sum), ...);
}

template <int... m>
void add_all(const TaylorModel& a, const TaylorModel& b, TaylorModel& sum, std::integer_sequence<int, m...>) {
  (add_degree<m>(a, b, sum, std::make_integer_sequence<int, taylor_order + 1 - m>()), ...);
}

}  // namespace

TaylorModel operator*(const TaylorModel& a, const TaylorModel& b) {
  TaylorModel s;
  const TaylorNorms of_a = norms(a), of_b = norms(b);
  add_all(a, b, s, std::make_integer_sequence<int, taylor_order + 1>());
  const double x = sum_of(of_a), y = sum_of(of_b);
  s.r = outward(a.r * y + b.r * x + a.r * b.r + cut_off(of_a, of_b) +
                (taylor_terms + 2) * unit_roundoff * x * y);
  return s;
}

// a = a0 (1 + d): the binomial series of d. Its coefficients get smaller, so what is cut off is no more than
// a geometric series.
TaylorModel power(const TaylorModel& a, double exponent) {
  constexpr double nearly_vanishes = 0.95;
  const double a0 = a.c[0];
  if (!(a0 > 0)) return unbounded();
  TaylorModel d = a * (1 / a0);
  d.c[0] = 0;
  d.r += 4 * unit_roundoff;
  const double size = norm(d) + d.r;
  if (!(size < nearly_vanishes)) return unbounded();
  std::array<double, taylor_order + 2> coefficient{1};
  for (int k = 1; k <= taylor_order + 1; ++k)
    coefficient[at(k)] = coefficient[at(k - 1)] * (exponent - k + 1) / k;
  TaylorModel sum = constant(coefficient[taylor_order]);
  for (int k = taylor_order - 1; k >= 0; --k) sum = sum * d + constant(coefficient[at(k)]);
  double tail = std::fabs(coefficient[taylor_order + 1]) / (1 - size);
  for (int k = 0; k <= taylor_order; ++k) tail *= size;
  sum.r = outward(sum.r + tail + 8 * unit_roundoff * norm(sum));
  return sum * (exponent == -1 ? 1 / a0 : exponent > 0 ? std::sqrt(a0) : 1 / std::sqrt(a0));
}

double greatest(const TaylorModel& a, std::span<const TaylorPlace> hull) {
  constexpr double hair = 1e-11;
  const double x = a.c[at(taylor_term(1, 0))], y = a.c[at(taylor_term(0, 1))];
  double linear = -std::numeric_limits<double>::infinity();
  for (const TaylorPlace& p : hull) linear = std::max(linear, x * p.x + y * p.y);
  double sum = a.c[0] + linear + hair * (std::fabs(x) + std::fabs(y));
  for (int m = 2; m <= taylor_order; ++m) {
    for (int j = 0; j <= m; ++j) {
      const double c = a.c[at(taylor_term(m - j, j))];
      const bool even = m % 2 == 0 && j % 2 == 0;  // between 0 and 1
      sum += even ? std::max(c, 0.0) : std::fabs(c);
    }
  }
  return sum + outward(a.r + (taylor_terms + 2) * unit_roundoff * norm(a));
}

double greatest_size(const TaylorModel& a) {
  return outward(norm(a) * (1 + taylor_terms * unit_roundoff) + a.r);
}

}  // namespace gabarit
