#include "gpu/device_error.h"

namespace gabarit {

// The numbers of cudaError_t, which a build without CUDA does not know; device_memory.cu holds them to it.
DeviceFault fault_of(int status) {
  switch (status) {
    case 2: return DeviceFault::memory;
    case 46:   // devices unavailable
    case 214:  // uncorrectable ECC error
    case 220:  // uncorrectable NVLink error
    case 226:  // contained error
    case 700:  // illegal address
    case 702:  // launch timeout
    case 714:  // hardware stack error
    case 715:  // illegal instruction
    case 716:  // misaligned address
    case 717:  // invalid address space
    case 718:  // invalid program counter
    case 719:  // launch failure
    case 999:  // unknown
      return DeviceFault::lost;
    case 209:  // no kernel image for the device
    case 218:  // invalid PTX
    case 222:  // unsupported PTX version
      return DeviceFault::no_code;
    default: return DeviceFault::other;
  }
}

void throw_device_error(int status, const std::string& device, const std::string& reason) {
  switch (fault_of(status)) {
    case DeviceFault::memory: throw OutOfDeviceMemory(device + " has not enough free memory");
    case DeviceFault::lost: throw DeviceError(device + " was lost while it computed: " + reason);
    case DeviceFault::no_code: throw DeviceError("this build has no code for " + device + ": " + reason);
    default: throw DeviceError(device + " cannot be used: " + reason);
  }
}

}  // namespace gabarit
