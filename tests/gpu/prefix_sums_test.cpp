#include "gpu/prefix_sums.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gpu/atomic.h"

namespace gabarit {
namespace {

TEST(PrefixSums, each_is_the_sum_of_those_before) {
  for (const Device& device : {Device::cpu(1), Device::simulated(1)}) {
    const PrefixSums sums =
        prefix_sums(device, Buffer<std::uint32_t>(device, std::vector<std::uint32_t>{3, 0, 4, 1}));
    EXPECT_THAT(sums.before.read(), testing::ElementsAre(0, 3, 3, 7));
    EXPECT_EQ(sums.total, 8U);
  }
}

TEST(PrefixSums, nothing_sums_to_nothing) {
  EXPECT_EQ(prefix_sums(Device::simulated(1), Buffer<std::uint32_t>()).total, 0U);
}

TEST(Atomic, floats_keep_their_order_as_numbers) {
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<float> ascending{-inf, -1e30F, -2, -1e-40F, 0, 1e-40F, 1, 3e8F, inf};
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    EXPECT_EQ(from_ordered(ordered(ascending[i])), ascending[i]);
    EXPECT_TRUE(i == 0 || ordered(ascending[i - 1]) < ordered(ascending[i]));
  }
  EXPECT_EQ(ordered(-0.0F), ordered(0.0F));
}

}  // namespace
}  // namespace gabarit
