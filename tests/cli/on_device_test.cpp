#include "cli/on_device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gabarit {
namespace {

std::string kind(const Device& device) { return device.has_own_memory() ? "device" : "cpu"; }

// Works on the CPU only.
std::string broken_device(const Device& device) {
  if (device.has_own_memory()) throw OutOfDeviceMemory("full");
  return kind(device);
}

const auto silent = [](const std::string&) { FAIL(); };

TEST(OnDevice, work_is_done_where_it_was_asked_for) {
  EXPECT_EQ(on_device(Device::cpu(1), false, kind, silent), "cpu");
  EXPECT_EQ(on_device(Device::simulated(1), false, kind, silent), "device");
}

TEST(OnDevice, a_device_that_fails_is_replaced_by_the_cpu_and_it_is_said) {
  std::string said;
  const auto notice = [&](const std::string& trouble) { said = trouble; };
  EXPECT_EQ(on_device(Device::simulated(1), false, broken_device, notice), "cpu");
  EXPECT_EQ(said, "full");
}

TEST(OnDevice, a_device_that_was_asked_for_by_name_is_not_replaced) {
  EXPECT_THROW(on_device(Device::simulated(1), true, broken_device, silent), DeviceError);
}

TEST(OnDevice, other_errors_are_let_through) {
  const auto work = [](const Device&) -> int { throw std::logic_error("a bug"); };
  EXPECT_THROW(on_device(Device::simulated(1), false, work, silent), std::logic_error);
}

}  // namespace
}  // namespace gabarit
