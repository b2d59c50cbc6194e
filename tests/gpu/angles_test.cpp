#include "gpu/angles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double right = 1.5707963267948966;

// In units of the last place of what is wanted.
double error(double got, long double wanted) {
  const double w = std::fabs(static_cast<double>(wanted));
  const double unit = std::nextafter(w, infinity) - w;
  return static_cast<double>(std::fabs(static_cast<long double>(got) - wanted) /
                             static_cast<long double>(unit));
}

class Angles : public testing::Test {
 protected:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  std::mt19937_64 random_{3};
};

TEST_F(Angles, sines_and_cosines_err_by_less_than_a_unit_of_the_last_place) {
  double greatest = 0;
  for (int i = 0; i < 300'000; ++i) {
    const double x = between(-1, 1) * (i % 3 == 0 ? 1.6 : i % 3 == 1 ? 7 : 1000);
    const auto [s, c] = sine_cosine(x);
    greatest = std::max({greatest, error(s, std::sin(static_cast<long double>(x))),
                         error(c, std::cos(static_cast<long double>(x)))});
  }
  EXPECT_LT(greatest, 1);
}

TEST_F(Angles, right_beside_multiples_of_a_right_angle_no_digits_are_lost) {
  double greatest = 0;
  for (int k = -900; k <= 900; ++k) {
    for (const double x :
         {k * right, std::nextafter(k * right, infinity), std::nextafter(k * right, -infinity)}) {
      const auto [s, c] = sine_cosine(x);
      greatest = std::max({greatest, error(s, std::sin(static_cast<long double>(x))),
                           error(c, std::cos(static_cast<long double>(x)))});
    }
  }
  EXPECT_LT(greatest, 1);
}

// The library's own long double function is right up to 2^63.
TEST_F(Angles, huge_angles_are_reduced_by_all_their_digits) {
  double greatest = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double x = std::ldexp(between(1, 2), i % 62) * (i % 2 == 0 ? 1 : -1);
    const auto [s, c] = sine_cosine(x);
    greatest = std::max({greatest, error(s, std::sin(static_cast<long double>(x))),
                         error(c, std::cos(static_cast<long double>(x)))});
  }
  EXPECT_LT(greatest, 1);
  // Beyond, glibc's function for doubles, which errs by less than 0.6 units.
  for (int i = 0; i < 100'000; ++i) {
    const double x = std::ldexp(between(1, 2), 62 + i % 961);
    const auto [s, c] = sine_cosine(x);
    ASSERT_LT(error(s, std::sin(x)), 2) << x;
    ASSERT_LT(error(c, std::cos(x)), 2) << x;
  }
}

TEST_F(Angles, the_double_that_is_nearest_to_a_multiple_of_a_right_angle_keeps_its_digits) {
  const double x = 0x1.6ac5b262ca1ffp849;  // 5.3e255: known to be the worst of all doubles
  EXPECT_LT(error(cosine(x), -4.68716592425462761112e-19L), 1.5);
  EXPECT_EQ(std::fabs(sine(x)), 1);
}

TEST_F(Angles, sines_and_cosines_of_zeros_infinities_and_nothing) {
  EXPECT_EQ(sine(0.0), 0);
  EXPECT_FALSE(std::signbit(sine(0.0)));
  EXPECT_TRUE(std::signbit(sine(-0.0)));
  EXPECT_EQ(cosine(-0.0), 1);
  EXPECT_EQ(sine(5e-324), 5e-324);
  for (const double x : {infinity, -infinity, not_a_number}) {
    EXPECT_TRUE(std::isnan(sine(x)));
    EXPECT_TRUE(std::isnan(cosine(x)));
  }
}

TEST_F(Angles, the_angle_of_a_point_errs_by_less_than_two_units) {
  double greatest = 0;
  for (int i = 0; i < 500'000; ++i) {
    const double y = between(-1, 1), x = between(-1, 1) * std::ldexp(1, i % 60 - 30);
    greatest =
        std::max(greatest,
                 error(angle_of(y, x), std::atan2(static_cast<long double>(y), static_cast<long double>(x))));
  }
  EXPECT_LT(greatest, 2);
}

TEST_F(Angles, on_axes_and_at_infinity_the_angle_of_a_point_is_that_of_the_library) {
  const std::vector<double> all{0.0,   -0.0,    1,        -1,     infinity, -infinity, not_a_number,
                                1e308, 1.7e308, -1.7e308, 5e-324, -5e-324,  1e-323,    1e-300};
  for (const double y : all) {
    for (const double x : all) {
      const double got = angle_of(y, x), wanted = std::atan2(y, x);
      EXPECT_TRUE(std::isnan(wanted) ? std::isnan(got)
                                     : error(got, wanted) < 2 && std::signbit(got) == std::signbit(wanted))
          << y << ", " << x << ": " << got;
    }
  }
}

TEST_F(Angles, the_arc_cosine_errs_by_less_than_three_units) {
  double greatest = 0;
  for (int i = 0; i < 500'000; ++i) {
    const double near = 1 - between(0, 1) * std::ldexp(1, -(i % 50)), x = i % 2 == 0 ? near : -near;
    greatest = std::max(greatest, error(arc_cosine(x), std::acos(static_cast<long double>(x))));
  }
  EXPECT_LT(greatest, 3);
  EXPECT_EQ(arc_cosine(1), 0);
  EXPECT_EQ(arc_cosine(0), right);
  EXPECT_EQ(arc_cosine(-1), 2 * right);
  EXPECT_TRUE(std::isnan(arc_cosine(1.0000000000000002)));
  EXPECT_TRUE(std::isnan(arc_cosine(not_a_number)));
}

TEST_F(Angles, hyperbolic_functions_err_by_less_than_two_units_up_to_their_overflow) {
  double greatest = 0;
  for (int i = 0; i < 300'000; ++i) {
    const double x = between(-1, 1) * (i % 3 == 0 ? 0.01 : i % 3 == 1 ? 2 : 710.47);
    const auto [s, c] = hyperbolic_sine_cosine(x);
    greatest = std::max({greatest, error(s, std::sinh(static_cast<long double>(x))),
                         error(c, std::cosh(static_cast<long double>(x)))});
  }
  EXPECT_LT(greatest, 2);
  for (const double x : {710.48, 711.0, 1e300, infinity}) {
    EXPECT_EQ(hyperbolic_sine_cosine(x).cosine, infinity);
    EXPECT_EQ(hyperbolic_sine_cosine(-x).sine, -infinity);
  }
  EXPECT_TRUE(std::signbit(hyperbolic_sine_cosine(-0.0).sine));
  EXPECT_EQ(hyperbolic_sine_cosine(0).cosine, 1);
  EXPECT_TRUE(std::isnan(hyperbolic_sine_cosine(not_a_number).sine));
}

}  // namespace
}  // namespace gabarit
