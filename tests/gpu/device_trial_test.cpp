#include "gpu/device_trial.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gpu/device_memory.h"

namespace gabarit {
namespace {

TEST(DeviceTrial, a_device_that_gives_the_bits_of_the_cpu_passes) {
  EXPECT_EQ(trial_of(Device::simulated(2)), "");
}

TEST(DeviceTrial, a_device_that_is_full_is_told_in_a_sentence) {
  MemoryLimit limit(1000);
  EXPECT_EQ(trial_of(Device::simulated(1, &limit)), "the memory limit of the device is reached");
}

TEST(DeviceTrial, a_device_that_is_not_there_is_told_in_a_sentence) {
  EXPECT_NE(trial_of(Device::cuda(63)), "");
}

}  // namespace
}  // namespace gabarit
