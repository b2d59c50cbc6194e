#include <numeric>

#include "gpu/parallel_for.h"
#include "gpu/prefix_sums.h"
#include "gpu/qualifiers.h"
#include "gpu/simulated_memory.h"

#if GABARIT_CUDA_COMPILER
#include <cub/device/device_scan.cuh>
#endif

namespace gabarit {
namespace {

#if GABARIT_CUDA_COMPILER
void scan_there(const Device& device, View<const std::uint32_t> in, View<std::uint32_t> out) {
  std::size_t bytes = 0;
  check_cuda(cudaSetDevice(device.index), device.index);
  check_cuda(cub::DeviceScan::ExclusiveSum(nullptr, bytes, in.data, out.data, in.size), device.index);
  const DeviceMemory room(device, bytes);
  check_cuda(cub::DeviceScan::ExclusiveSum(room.data(), bytes, in.data, out.data, in.size), device.index);
  check_cuda(cudaDeviceSynchronize(), device.index);
}
#else
void scan_there(const Device&, View<const std::uint32_t>, View<std::uint32_t>) {
  throw std::logic_error("a scan that was not compiled for CUDA cannot run there");
}
#endif

struct Last {
  View<const std::uint32_t> counts, before;
  View<std::uint32_t> total;

  GABARIT_HD void operator()(std::int64_t) const {
    total[0] = counts[counts.size - 1] + before[counts.size - 1];
  }
};

}  // namespace

PrefixSums prefix_sums(const Device& device, const Buffer<std::uint32_t>& counts) {
  PrefixSums sums{Buffer<std::uint32_t>::of_size(device, counts.size()), 0};
  const View<const std::uint32_t> in = counts.view();
  if (in.size == 0) return sums;
  if (device.kind == Device::Kind::cuda) {
    scan_there(device, in, sums.before.view());
  } else {
    const SimulatedAccess access;
    std::exclusive_scan(in.data, in.data + in.size, sums.before.view().data, 0U);
  }
  auto total = Buffer<std::uint32_t>::of_size(device, 1);
  parallel_for(device, 1, Last{in, std::as_const(sums.before).view(), total.view()});
  sums.total = total.read().front();
  return sums;
}

}  // namespace gabarit
