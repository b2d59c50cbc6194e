// Memory of a CUDA device, owned. A build without CUDA has no such device: asking for one throws.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "gpu/device.h"

namespace gabarit {

class DeviceMemory {
 public:
  DeviceMemory() = default;
  // Throws std::runtime_error when the device is missing or its memory is exhausted.
  DeviceMemory(const Device& device, std::size_t bytes);

  void* data() const { return data_.get(); }
  void write(const void* from, std::size_t bytes);
  void read(void* into, std::size_t bytes) const;

 private:
  std::shared_ptr<void> data_;
};

// The names of the CUDA devices that can be used now, by index; empty in a build without CUDA.
std::vector<std::string> cuda_devices();

}  // namespace gabarit
