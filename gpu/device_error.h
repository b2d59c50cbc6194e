// What goes wrong with a device while it computes.
#pragma once

#include <stdexcept>
#include <string>

namespace gabarit {

// The device is missing, was lost or refuses to work. The message is a sentence that names it.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Its memory is exhausted; smaller pieces may fit.
class OutOfDeviceMemory : public DeviceError {
 public:
  using DeviceError::DeviceError;
};

enum class DeviceFault {
  memory,   // exhausted
  lost,     // nothing can be computed on it any more by this process
  no_code,  // this build has none for it
  other,
};

// `status`: of the CUDA runtime, not 0.
DeviceFault fault_of(int status);

// `device`: such as "CUDA device 0 (NVIDIA H100)"; `reason`: CUDA's words for the status.
[[noreturn]] void throw_device_error(int status, const std::string& device, const std::string& reason);

}  // namespace gabarit
