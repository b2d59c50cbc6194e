#include "gpu/no_greater.h"

#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace gabarit {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// By every set of vector instructions that this machine has.
void expect_mask(const EightFloats& x, float limit, unsigned mask) {
  EXPECT_EQ(no_greater<VectorSet::portable>(x, limit), mask);
  if (available(VectorSet::avx2) == VectorSet::avx2) {
    EXPECT_EQ(no_greater<VectorSet::avx2>(x, limit), mask);
  }
  if (available(VectorSet::avx512) == VectorSet::avx512) {
    EXPECT_EQ(no_greater<VectorSet::avx512>(x, limit), mask);
  }
}

TEST(NoGreater, a_bit_stands_for_a_float_at_or_under_the_limit) {
  expect_mask({{1, 2, 3, 4, 5, 6, 7, 8}}, 3, 0b00000111);
  expect_mask({{8, 7, 6, 5, 4, 3, 2, 1}}, 3, 0b11100000);
  expect_mask({{1, 2, 3, 4, 5, 6, 7, 8}}, 0.5F, 0);
}

TEST(NoGreater, infinity_is_beyond_every_finite_limit_and_no_number_is_within_none) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  expect_mask({{infinity, -infinity, nan, 0, -0.0F, 1e30F, infinity, nan}}, 0, 0b00011010);
  expect_mask({{0, 0, 0, 0, 0, 0, 0, 0}}, nan, 0);
}

TEST(NoGreater, all_sets_of_instructions_agree_with_one_comparison_each) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> value(-3, 3);
  for (int round = 0; round < 2000; ++round) {
    EightFloats x;
    unsigned mask = 0;
    const auto limit = static_cast<float>(value(random));
    for (int i = 0; i < 8; ++i) {
      x[i] = static_cast<float>(value(random));
      if (x[i] <= limit) mask |= 1U << i;
    }
    expect_mask(x, limit, mask);
  }
}

}  // namespace
}  // namespace gabarit
