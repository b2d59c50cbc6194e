// Memory of a device that has its own, owned.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "gpu/device.h"

namespace gabarit {

// How much may be held at a time, by all that was given this limit.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t bytes) : left_(bytes) {}

  bool take(std::size_t bytes);  // false: there is not enough left
  void give_back(std::size_t bytes) { left_ += bytes; }

 private:
  std::atomic<std::size_t> left_;
};

class DeviceMemory {
 public:
  DeviceMemory() = default;
  // Throws OutOfDeviceMemory when there is not enough, DeviceError when the device is missing or lost; a
  // build without CUDA has no such device.
  DeviceMemory(const Device& device, std::size_t bytes);

  void* data() const { return data_.get(); }
  void write(const void* from, std::size_t bytes);
  void read(void* into, std::size_t bytes) const;

 private:
  Device device_;
  std::shared_ptr<void> data_;
};

// The names of the CUDA devices that the driver knows, by index; empty in a build without CUDA.
std::vector<std::string> cuda_devices();

}  // namespace gabarit
