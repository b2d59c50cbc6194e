// The steps of a contact on a device that has not room enough for them.
#include <algorithm>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "gpu/bumpy_ball.h"
#include "gpu/query_trials.h"
#include "tests/gpu/other_devices.h"

namespace gabarit {
namespace {

std::vector<std::uint64_t> bits_of(const QueryTrial& trial, const FacetSurface& surface,
                                   const Device& device) {
  const PreparedTrial prepared = trial.prepare(device, surface);
  prepared.run();
  return prepared.bits();
}

class TightMemory : public testing::TestWithParam<const char*> {};

TEST_P(TightMemory, work_is_done_in_parts_and_gives_the_same_bits) {
  const FacetSurface surface = bumpy_ball(80, 120, 10, 0.2);
  const auto trial = std::find_if(query_trials().begin(), query_trials().end(),
                                  [](const QueryTrial& t) { return std::string_view(t.name) == GetParam(); });
  ASSERT_NE(trial, query_trials().end());
  const std::vector<std::uint64_t> expected = bits_of(*trial, surface, plain_cpu);
  for (const std::size_t room : {std::size_t{1} << 24, std::size_t{1} << 20, std::size_t{1} << 18}) {
    MemoryLimit limit(room);
    EXPECT_TRUE(expected == bits_of(*trial, surface, Device::simulated(2, &limit))) << room;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryStep, TightMemory,
                         testing::Values("plan projection", "outline raster", "distance transform",
                                         "facets near", "contact depths", "dexels"),
                         [](const auto& step) {
                           std::string name = step.param;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

}  // namespace
}  // namespace gabarit
