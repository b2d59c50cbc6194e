// Runs a kernel for every index of a range. A kernel is a trivially copyable struct of views with
// `void operator()(std::int64_t i) const`, free of side effects on other indices: the result does not depend
// on the order. On a CPU every kernel is compiled for several sets of vector instructions, with everything it
// calls inlined, and the widest is picked when it starts; without contraction all give the same bits. A
// kernel runs on CUDA when its source file is compiled by nvcc (the .cu files); others go to device.host().
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>

#include "gpu/device.h"
#include "gpu/qualifiers.h"
#include "gpu/simulated_memory.h"

namespace gabarit {

// Calls body(context, begin, end) for disjoint chunks that cover [0, n), on at most `threads` threads (0: all
// cores).
void run_chunks(int threads, std::int64_t n, std::int64_t grain, void* context,
                void (*body)(void* context, std::int64_t begin, std::int64_t end));

// A kernel that is written for the set gets to know it.
template <VectorSet set, class Kernel>
GABARIT_HD inline void run_index(const Kernel& kernel, std::int64_t i) {
  if constexpr (requires { kernel.template run<set>(i); })
    kernel.template run<set>(i);
  else
    kernel(i);
}

template <class Kernel>
void run_portable(void* kernel, std::int64_t begin, std::int64_t end) {
  for (std::int64_t i = begin; i < end; ++i)
    run_index<VectorSet::portable>(*static_cast<const Kernel*>(kernel), i);
}

#if GABARIT_X86
template <class Kernel>
__attribute__((target("avx2"), flatten)) void run_avx2(void* kernel, std::int64_t begin, std::int64_t end) {
  for (std::int64_t i = begin; i < end; ++i)
    run_index<VectorSet::avx2>(*static_cast<const Kernel*>(kernel), i);
}
template <class Kernel>
__attribute__((target("avx512f,avx512vl,avx512dq"), flatten)) void run_avx512(void* kernel,
                                                                              std::int64_t begin,
                                                                              std::int64_t end) {
  for (std::int64_t i = begin; i < end; ++i)
    run_index<VectorSet::avx512>(*static_cast<const Kernel*>(kernel), i);
}
#endif

template <class Kernel>
auto chunk_runner(VectorSet wanted) {
#if GABARIT_X86
  const VectorSet set = available(wanted);
  if (set == VectorSet::avx512) return &run_avx512<Kernel>;
  if (set == VectorSet::avx2) return &run_avx2<Kernel>;
#endif
  return &run_portable<Kernel>;
}

// A CUDA grid has fewer than 2^31 blocks: more indices than these go in several launches.
constexpr int indices_in_a_block = 128;
constexpr std::int64_t most_indices_in_a_launch = indices_in_a_block * ((std::int64_t{1} << 31) - 1);

// Calls launch(begin, end, blocks) for the parts of [0, n) that one launch takes.
template <class Launch>
void in_launches(std::int64_t n, Launch&& launch) {
  for (std::int64_t begin = 0; begin < n; begin += most_indices_in_a_launch) {
    const std::int64_t end = n - begin > most_indices_in_a_launch ? begin + most_indices_in_a_launch : n;
    launch(begin, end, static_cast<unsigned>((end - begin + indices_in_a_block - 1) / indices_in_a_block));
  }
}

#if GABARIT_CUDA_COMPILER
// Throws DeviceError unless the status (a cudaError_t) is a success.
void check_cuda(int status, int device);

template <class Kernel>
__global__ void cuda_kernel(Kernel kernel, std::int64_t begin, std::int64_t end) {
  const std::int64_t i = begin + static_cast<std::int64_t>(blockIdx.x) * blockDim.x + threadIdx.x;
  if (i < end) run_index<VectorSet::portable>(kernel, i);
}
template <class Kernel>
void run_cuda(const Device& device, std::int64_t n, const Kernel& kernel) {
  check_cuda(cudaSetDevice(device.index), device.index);
  in_launches(n, [&](std::int64_t begin, std::int64_t end, unsigned blocks) {
    cuda_kernel<<<blocks, indices_in_a_block>>>(kernel, begin, end);
    check_cuda(cudaGetLastError(), device.index);
  });
  check_cuda(cudaDeviceSynchronize(), device.index);
}
#else
template <class Kernel>
void run_cuda(const Device&, std::int64_t, const Kernel&) {
  throw std::logic_error("a kernel that was not compiled for CUDA cannot run there");
}
#endif

// Throws what a kernel throws, and DeviceError. `grain`: how many indices are worth a hand-over to another
// thread.
template <class Kernel>
void parallel_for(const Device& device, std::int64_t n, const Kernel& kernel, std::int64_t grain = 1024) {
#if !GABARIT_DEVICE_SOURCE
  if (device.has_own_memory())
    throw std::logic_error("a kernel outside the .cu files cannot run on a device");
#endif
  if (device.kind == Device::Kind::cuda) return run_cuda(device, n, kernel);
  std::optional<SimulatedAccess> access;
  if (device.has_own_memory()) access.emplace();
  run_chunks(device.threads, n, grain, const_cast<Kernel*>(&kernel), chunk_runner<Kernel>(device.vectors));
}

// The same for code that only a CPU runs, such as a lambda that builds something.
template <class Kernel>
void parallel_for_cpu(const Device& device, std::int64_t n, const Kernel& kernel, std::int64_t grain) {
  run_chunks(device.threads, n, grain, const_cast<Kernel*>(&kernel), &run_portable<Kernel>);
}

}  // namespace gabarit
