// Runs a kernel for every index of a range. A kernel is a trivially copyable struct of views with
// `void operator()(std::int64_t i) const`, free of side effects on other indices: the result does not depend
// on the order. On a CPU every kernel is compiled for several sets of vector instructions, with everything it
// calls inlined, and the widest is picked when it starts; without contraction all give the same bits. A
// kernel runs on CUDA when its source file is compiled by nvcc (the .cu files).
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "gpu/device.h"
#include "gpu/qualifiers.h"

namespace gabarit {

// Calls body(context, begin, end) for disjoint chunks that cover [0, n), on at most `threads` threads (0: all
// cores).
void run_chunks(int threads, std::int64_t n, std::int64_t grain, void* context,
                void (*body)(void* context, std::int64_t begin, std::int64_t end));

template <class Kernel>
void run_portable(void* kernel, std::int64_t begin, std::int64_t end) {
  for (std::int64_t i = begin; i < end; ++i) (*static_cast<const Kernel*>(kernel))(i);
}

#if GABARIT_X86
template <class Kernel>
__attribute__((target("avx2"), flatten)) void run_avx2(void* kernel, std::int64_t begin, std::int64_t end) {
  for (std::int64_t i = begin; i < end; ++i) (*static_cast<const Kernel*>(kernel))(i);
}
template <class Kernel>
__attribute__((target("avx512f,avx512vl,avx512dq"), flatten)) void run_avx512(void* kernel,
                                                                              std::int64_t begin,
                                                                              std::int64_t end) {
  for (std::int64_t i = begin; i < end; ++i) (*static_cast<const Kernel*>(kernel))(i);
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

#if GABARIT_CUDA_COMPILER
template <class Kernel>
__global__ void cuda_kernel(Kernel kernel, std::int64_t n) {
  const std::int64_t i = static_cast<std::int64_t>(blockIdx.x) * blockDim.x + threadIdx.x;
  if (i < n) kernel(i);
}
template <class Kernel>
void run_cuda(const Device& device, std::int64_t n, const Kernel& kernel) {
  constexpr int block = 128;
  if (n <= 0) return;
  cudaSetDevice(device.index);
  cuda_kernel<<<static_cast<unsigned>((n + block - 1) / block), block>>>(kernel, n);
  if (const cudaError_t status = cudaDeviceSynchronize(); status != cudaSuccess)
    throw std::runtime_error(std::string("CUDA: ") + cudaGetErrorString(status));
}
#else
template <class Kernel>
void run_cuda(const Device&, std::int64_t, const Kernel&) {
  throw std::runtime_error("this build has no CUDA support");
}
#endif

// Throws what a kernel throws. `grain`: how many indices are worth a hand-over to another thread.
template <class Kernel>
void parallel_for(const Device& device, std::int64_t n, const Kernel& kernel, std::int64_t grain = 1024) {
  if (device.kind == Device::Kind::cuda) return run_cuda(device, n, kernel);
  run_chunks(device.threads, n, grain, const_cast<Kernel*>(&kernel), chunk_runner<Kernel>(device.vectors));
}

// The same for code that only a CPU runs, such as a lambda that builds something.
template <class Kernel>
void parallel_for_cpu(const Device& device, std::int64_t n, const Kernel& kernel, std::int64_t grain) {
  run_chunks(device.threads, n, grain, const_cast<Kernel*>(&kernel), &run_portable<Kernel>);
}

}  // namespace gabarit
