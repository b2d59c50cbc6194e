#include "checks/taylor_model.h"

#include <functional>
#include <random>

#include <gtest/gtest.h>

namespace gabarit {
namespace {

TaylorModel random_model(std::mt19937& random, double constant_term) {
  std::uniform_real_distribution<double> in(-1, 1);
  TaylorModel m = constant(constant_term);
  for (std::size_t i = 1; i < m.c.size(); ++i) m.c[i] = 0.1 * in(random);
  return m;
}

double polynomial(const TaylorModel& m, double x, double y) {
  double sum = 0;
  for (int i = 0; i <= taylor_order; ++i) {
    for (int j = 0; i + j <= taylor_order; ++j)
      sum += m.c[static_cast<std::size_t>(taylor_term(i, j))] * std::pow(x, i) * std::pow(y, j);
  }
  return sum;
}

// At a grid of places with the corners: the function differs from the model by no more than its remainder,
// and is no greater than its bounds.
void expect_encloses(const TaylorModel& m, const std::function<double(double, double)>& f) {
  constexpr std::array<TaylorPlace, 4> everywhere{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  constexpr std::array<TaylorPlace, 3> half{{{-1, -1}, {1, -1}, {-1, 1}}};
  for (int i = -8; i <= 8; ++i) {
    for (int j = -8; j <= 8; ++j) {
      const double x = i / 8., y = j / 8., value = f(x, y);
      EXPECT_LE(std::fabs(value - polynomial(m, x, y)), m.r + 1e-15 * std::fabs(value));
      EXPECT_LE(value, greatest(m, everywhere));
      EXPECT_LE(std::fabs(value), greatest_size(m));
      if (x + y <= 0) {
        EXPECT_LE(value, greatest(m, half));
      }
    }
  }
}

TEST(TaylorModel, products_and_powers_of_random_polynomials_stay_within_their_remainders) {
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round) {
    const TaylorModel a = random_model(random, 1.5), b = random_model(random, -0.5),
                      c = random_model(random, 3);
    const auto value = [&](const TaylorModel& m) {
      return [&m](double x, double y) { return polynomial(m, x, y); };
    };
    const auto of_a = value(a), of_b = value(b), of_c = value(c);
    expect_encloses(a * b - c, [&](double x, double y) { return of_a(x, y) * of_b(x, y) - of_c(x, y); });
    expect_encloses(power(c, -1), [&](double x, double y) { return 1 / of_c(x, y); });
    expect_encloses(power(c, 0.5), [&](double x, double y) { return std::sqrt(of_c(x, y)); });
    expect_encloses(power(c, -0.5) * a,
                    [&](double x, double y) { return of_a(x, y) / std::sqrt(of_c(x, y)); });
  }
}

TEST(TaylorModel, what_a_remainder_holds_goes_through_every_operation) {
  TaylorModel a = constant(2);
  a.r = 0.25;  // anything between 1.75 and 2.25
  for (const double inside : {1.75, 2.0, 2.25}) {
    EXPECT_LE(std::fabs(inside * inside - (a * a).c[0]), (a * a).r);
    EXPECT_LE(std::fabs(1 / inside - power(a, -1).c[0]), power(a, -1).r);
    EXPECT_LE(std::fabs(std::sqrt(inside) - power(a, 0.5).c[0]), power(a, 0.5).r);
  }
}

TEST(TaylorModel, a_power_of_what_may_vanish_has_no_bound) {
  TaylorModel a = constant(1);
  a.c[1] = 1;
  EXPECT_EQ(power(a, -1).r, std::numeric_limits<double>::infinity());
  EXPECT_EQ(power(constant(-1), 0.5).r, std::numeric_limits<double>::infinity());
}

TEST(TaylorModel, a_polynomial_of_few_terms_is_exact_to_rounding) {
  TaylorModel a = constant(1);
  a.c[taylor_term(1, 0)] = 2, a.c[taylor_term(0, 1)] = -3;
  const TaylorModel square = a * a;
  EXPECT_EQ(square.c[taylor_term(1, 1)], -12);
  EXPECT_LT(square.r, 1e-12);
  constexpr std::array<TaylorPlace, 2> line{{{-1, -1}, {1, 1}}};
  EXPECT_NEAR(greatest(a, line), 2, 1e-9);  // 1 - x along the diagonal
}

}  // namespace
}  // namespace gabarit
