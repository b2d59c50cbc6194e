// An array in the memory of a device.
#pragma once

#include <algorithm>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "gpu/device.h"
#include "gpu/device_memory.h"
#include "gpu/view.h"

namespace gabarit {

// On a CPU it is the vector it was given, elsewhere a copy in the device's memory. Throws DeviceError and
// OutOfDeviceMemory.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Buffer() = default;
  Buffer(const Device& device, std::vector<T> elements)
      : host_(std::move(elements)), size_(static_cast<std::int64_t>(host_.size())) {
    if (!device.has_own_memory()) return;
    remote_ = DeviceMemory(device, bytes());
    remote_.write(host_.data(), bytes());
    host_ = {};
  }
  Buffer(const Device& device, std::span<const T> elements)
      : size_(static_cast<std::int64_t>(elements.size())) {
    if (!device.has_own_memory()) {
      host_.assign(elements.begin(), elements.end());
      return;
    }
    remote_ = DeviceMemory(device, bytes());
    remote_.write(elements.data(), bytes());
  }
  // For a kernel to write to: what is in it cannot be relied on.
  static Buffer of_size(const Device& device, std::int64_t n) {
    if (!device.has_own_memory()) return {device, std::vector<T>(static_cast<std::size_t>(n))};
    Buffer buffer;
    buffer.size_ = n;
    buffer.remote_ = DeviceMemory(device, buffer.bytes());
    return buffer;
  }

  View<T> view() { return {remote_.data() ? static_cast<T*>(remote_.data()) : host_.data(), size_}; }
  View<const T> view() const {
    return {remote_.data() ? static_cast<const T*>(remote_.data()) : host_.data(), size_};
  }
  void read(std::span<T> into) const {
    if (remote_.data()) return remote_.read(into.data(), bytes());
    std::copy(host_.begin(), host_.end(), into.begin());
  }
  std::vector<T> read() && {
    if (!remote_.data()) return std::move(host_);
    return std::as_const(*this).read();
  }
  std::vector<T> read() const& {
    std::vector<T> all(static_cast<std::size_t>(size_));
    read(std::span<T>(all));
    return all;
  }
  std::int64_t size() const { return size_; }
  std::size_t bytes() const { return static_cast<std::size_t>(size_) * sizeof(T); }

 private:
  std::vector<T> host_;
  DeviceMemory remote_;
  std::int64_t size_ = 0;
};

}  // namespace gabarit
