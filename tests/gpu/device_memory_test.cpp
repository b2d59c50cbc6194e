#include "gpu/device_memory.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gpu/buffer.h"
#include "gpu/device_error.h"
#include "gpu/simulated_memory.h"

namespace gabarit {
namespace {

TEST(DeviceMemory, holds_what_was_written_apart_from_the_host) {
  std::array<int, 3> numbers{1, 2, 3};
  DeviceMemory memory(Device::simulated(), sizeof numbers);
  memory.write(numbers.data(), sizeof numbers);
  numbers = {};
  std::array<int, 3> back{};
  memory.read(back.data(), sizeof back);
  EXPECT_THAT(back, testing::ElementsAre(1, 2, 3));
}

TEST(DeviceMemoryDeathTest, the_cpu_cannot_look_into_it_as_into_that_of_a_gpu) {
  const DeviceMemory memory(Device::simulated(), sizeof(int));
  const volatile int* const place = static_cast<const int*>(memory.data());
  EXPECT_DEATH(static_cast<void>(*place), "");
  const SimulatedAccess access;  // as kernels have
  EXPECT_EQ(*place, 0);
}

TEST(DeviceMemory, more_than_the_limit_is_out_of_memory_and_what_is_freed_can_be_had_again) {
  MemoryLimit limit(100);
  const Device device = Device::simulated(1, &limit);
  {
    const DeviceMemory some(device, 60);
    EXPECT_THROW(DeviceMemory(device, 41), OutOfDeviceMemory);
    EXPECT_NO_THROW(DeviceMemory(device, 40));
  }
  EXPECT_NO_THROW(DeviceMemory(device, 100));
}

TEST(DeviceMemory, a_buffer_of_nothing_is_one) {
  const Buffer<double> none(Device::simulated(), std::vector<double>{});
  EXPECT_EQ(none.size(), 0);
  EXPECT_TRUE(none.read().empty());
}

TEST(DeviceMemory, a_device_that_is_not_there_is_a_device_error) {
  EXPECT_THROW(DeviceMemory(Device::cuda(63), 8), DeviceError);
}

std::string sentence(int status) {
  try {
    throw_device_error(status, "CUDA device 0 (Some GPU)", "words of the runtime");
  } catch (const OutOfDeviceMemory& error) {
    return std::string("memory: ") + error.what();
  } catch (const DeviceError& error) {
    return error.what();
  }
}

TEST(DeviceError, every_fault_is_one_sentence_that_names_the_device) {
  EXPECT_EQ(sentence(2), "memory: CUDA device 0 (Some GPU) has not enough free memory");
  for (const int lost : {46, 214, 700, 719})
    EXPECT_EQ(sentence(lost), "CUDA device 0 (Some GPU) was lost while it computed: words of the runtime");
  EXPECT_EQ(sentence(209), "this build has no code for CUDA device 0 (Some GPU): words of the runtime");
  EXPECT_EQ(sentence(35), "CUDA device 0 (Some GPU) cannot be used: words of the runtime");
}

}  // namespace
}  // namespace gabarit
