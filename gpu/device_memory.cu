#include <stdexcept>

#include "gpu/device_memory.h"
#include "gpu/qualifiers.h"

namespace gabarit {

#if GABARIT_CUDA_COMPILER

void check_cuda(cudaError_t status) {
  if (status != cudaSuccess) throw std::runtime_error(std::string("CUDA: ") + cudaGetErrorString(status));
}

DeviceMemory::DeviceMemory(const Device& device, std::size_t bytes) {
  check_cuda(cudaSetDevice(device.index));
  void* data = nullptr;
  check_cuda(cudaMalloc(&data, bytes > 0 ? bytes : 1));
  data_ = std::shared_ptr<void>(data, [](void* p) { cudaFree(p); });
}

void DeviceMemory::write(const void* from, std::size_t bytes) {
  check_cuda(cudaMemcpy(data_.get(), from, bytes, cudaMemcpyHostToDevice));
}

void DeviceMemory::read(void* into, std::size_t bytes) const {
  check_cuda(cudaMemcpy(into, data_.get(), bytes, cudaMemcpyDeviceToHost));
}

std::vector<std::string> cuda_devices() {
  int count = 0;
  if (cudaGetDeviceCount(&count) != cudaSuccess) return {};
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) {
    cudaDeviceProp properties{};
    check_cuda(cudaGetDeviceProperties(&properties, i));
    names.emplace_back(properties.name);
  }
  return names;
}

#else

DeviceMemory::DeviceMemory(const Device&, std::size_t) {
  throw std::runtime_error("this build has no CUDA support");
}
void DeviceMemory::write(const void*, std::size_t) {}
void DeviceMemory::read(void*, std::size_t) const {}
std::vector<std::string> cuda_devices() { return {}; }

#endif

}  // namespace gabarit
