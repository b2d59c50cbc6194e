#include "report/ticks.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>

namespace gabarit {
namespace {

using testing::ElementsAre;

TEST(round_numbers, are_1_2_and_5_times_a_power_of_ten) {
  EXPECT_EQ(round_up(1), 1);
  EXPECT_EQ(round_up(1.01), 2);
  EXPECT_EQ(round_up(0.3), 0.5);
  EXPECT_EQ(round_up(501), 1000);
  EXPECT_EQ(round_down(1000), 1000);
  EXPECT_EQ(round_down(999), 500);
  EXPECT_EQ(round_down(0.0049), 0.002);
}

TEST(round_numbers, embrace_the_value_within_a_factor_of_2_and_a_half) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-290, 290);
  for (int i = 0; i < 2000; ++i) {
    const double value = std::pow(10.0, exponent(random));
    EXPECT_GE(round_up(value), value);
    EXPECT_LE(round_up(value), value * 2.51);
    EXPECT_LE(round_down(value), value);
    EXPECT_GE(round_down(value), value / 2.51);
  }
}

TEST(ticks, of_0_to_10_at_most_6_are_even_numbers) {
  const Ticks t = ticks(0, 10, 6);
  EXPECT_THAT(t.values, ElementsAre(0, 2, 4, 6, 8, 10));
  EXPECT_EQ(t.text(4), "4");
}

TEST(ticks, say_as_many_decimals_as_tell_them_apart) {
  EXPECT_EQ(ticks(0, 1, 5).text(0.6), "0.6");
  EXPECT_EQ(ticks(0, 0.08, 5).text(0.04), "0.04");
  EXPECT_EQ(ticks(-1, 1, 5).text(-0.0), "0.0");
}

TEST(ticks, lie_inside_the_range_and_are_never_more_than_asked) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> at(-1000, 1000);
  for (int i = 0; i < 2000; ++i) {
    const double a = at(random);
    const double b = at(random);
    const Ticks t = ticks(std::min(a, b), std::max(a, b), 8);
    EXPECT_LE(t.values.size(), 8U);
    EXPECT_GE(t.values.size(), 2U);
    EXPECT_GE(t.values.front(), std::min(a, b) - 1e-9);
    EXPECT_LE(t.values.back(), std::max(a, b) + 1e-9);
  }
}

TEST(ticks, of_no_range_are_none) {
  EXPECT_TRUE(ticks(1, 1, 5).values.empty());
  EXPECT_TRUE(ticks(2, 1, 5).values.empty());
  EXPECT_TRUE(ticks(0, INFINITY, 5).values.empty());
  EXPECT_TRUE(ticks(NAN, 1, 5).values.empty());
  EXPECT_TRUE(ticks(-1.7e308, 1.7e308, 5).values.empty());
}

}  // namespace
}  // namespace gabarit
