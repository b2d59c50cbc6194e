#include <cstring>
#include <utility>

#include "gpu/device_error.h"
#include "gpu/device_memory.h"
#include "gpu/qualifiers.h"
#include "gpu/simulated_memory.h"

namespace gabarit {

#if GABARIT_CUDA_COMPILER

// device_error.cpp knows them by number.
static_assert(cudaErrorMemoryAllocation == 2 && cudaErrorDevicesUnavailable == 46 &&
              cudaErrorNoKernelImageForDevice == 209 && cudaErrorECCUncorrectable == 214 &&
              cudaErrorInvalidPtx == 218 && cudaErrorUnsupportedPtxVersion == 222 &&
              cudaErrorNvlinkUncorrectable == 220 && cudaErrorContained == 226 &&
              cudaErrorIllegalAddress == 700 && cudaErrorLaunchTimeout == 702 &&
              cudaErrorHardwareStackError == 714 && cudaErrorIllegalInstruction == 715 &&
              cudaErrorMisalignedAddress == 716 && cudaErrorInvalidAddressSpace == 717 &&
              cudaErrorInvalidPc == 718 && cudaErrorLaunchFailure == 719 && cudaErrorUnknown == 999);

// A lost device may not tell its name any more.
static std::string name_of(int index) {
  const std::string number = "CUDA device " + std::to_string(index);
  cudaDeviceProp properties{};
  if (cudaGetDeviceProperties(&properties, index) != cudaSuccess) return number;
  return number + " (" + properties.name + ")";
}

void check_cuda(int status, int index) {
  if (status == cudaSuccess) return;
  // An error that does not last must not be found again by the next call.
  static_cast<void>(cudaGetLastError());
  throw_device_error(status, name_of(index), cudaGetErrorString(static_cast<cudaError_t>(status)));
}

static void* allocate_there(const Device& device, std::size_t bytes) {
  void* data = nullptr;
  check_cuda(cudaSetDevice(device.index), device.index);
  check_cuda(cudaMalloc(&data, bytes), device.index);
  return data;
}

// A device that is lost has freed it already.
static void free_there(const Device&, void* data) { static_cast<void>(cudaFree(data)); }

static void copy_there(const Device& device, void* to, const void* from, std::size_t bytes) {
  check_cuda(cudaSetDevice(device.index), device.index);
  check_cuda(cudaMemcpy(to, from, bytes, cudaMemcpyDefault), device.index);
}

std::vector<std::string> cuda_devices() {
  int count = 0;
  if (cudaGetDeviceCount(&count) != cudaSuccess) return {};
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) {
    cudaDeviceProp properties{};
    const bool known = cudaGetDeviceProperties(&properties, i) == cudaSuccess;
    names.emplace_back(known ? properties.name : "does not answer");
  }
  return names;
}

#else

static void* allocate_there(const Device&, std::size_t) {
  throw DeviceError("this build has no CUDA support");
}
static void free_there(const Device&, void*) {}
static void copy_there(const Device&, void*, const void*, std::size_t) {}
std::vector<std::string> cuda_devices() { return {}; }

#endif

static void* allocate(const Device& device, std::size_t bytes) {
  if (device.kind == Device::Kind::cuda) return allocate_there(device, bytes);
  void* const data = allocate_simulated(bytes);
  if (data == nullptr) throw OutOfDeviceMemory("the simulated device has not enough free memory");
  return data;
}

static void release(const Device& device, void* data, std::size_t bytes) {
  device.kind == Device::Kind::cuda ? free_there(device, data) : release_simulated(data);
  if (device.limit != nullptr) device.limit->give_back(bytes);
}

bool MemoryLimit::take(std::size_t bytes) {
  std::size_t left = left_.load();
  do {
    if (left < bytes) return false;
  } while (!left_.compare_exchange_weak(left, left - bytes));
  return true;
}

DeviceMemory::DeviceMemory(const Device& device, std::size_t bytes) : device_(device) {
  bytes = bytes > 0 ? bytes : 1;
  if (device.limit != nullptr && !device.limit->take(bytes))
    throw OutOfDeviceMemory("the memory limit of the device is reached");
  void* data = nullptr;
  try {
    data = allocate(device, bytes);
  } catch (...) {
    if (device.limit != nullptr) device.limit->give_back(bytes);
    throw;
  }
  data_ = std::shared_ptr<void>(data, [device, bytes](void* p) { release(device, p, bytes); });
}

void DeviceMemory::write(const void* from, std::size_t bytes) {
  if (bytes == 0) return;
  if (device_.kind == Device::Kind::cuda) return copy_there(device_, data_.get(), from, bytes);
  const SimulatedAccess access;
  std::memcpy(data_.get(), from, bytes);
}

void DeviceMemory::read(void* into, std::size_t bytes) const {
  if (bytes == 0) return;
  if (device_.kind == Device::Kind::cuda) return copy_there(device_, into, data_.get(), bytes);
  const SimulatedAccess access;
  std::memcpy(into, data_.get(), bytes);
}

}  // namespace gabarit
