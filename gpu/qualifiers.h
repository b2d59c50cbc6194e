// Marks functions that run on the CPU and on the GPU. One of the three files that may ask which compiler
// reads them (the others: parallel_for.h, device_memory.cu).
#pragma once

// GABARIT_UNROLL before a short loop: a GPU keeps arrays in registers when it knows all their indices.
#if defined(__CUDACC__)
#define GABARIT_HD __host__ __device__
#define GABARIT_CUDA_COMPILER 1
#define GABARIT_UNROLL _Pragma("unroll")
#else
#define GABARIT_HD
#define GABARIT_CUDA_COMPILER 0
#define GABARIT_UNROLL
#endif

// 1 in the .cu files, whichever compiler reads them: their kernels can run on a device.
#if !defined(GABARIT_DEVICE_SOURCE)
#define GABARIT_DEVICE_SOURCE 0
#endif

#if defined(__CUDA_ARCH__)
#define GABARIT_ON_GPU 1
#else
#define GABARIT_ON_GPU 0
#endif

#if defined(__x86_64__) && defined(__GNUC__)
#define GABARIT_X86 1
#else
#define GABARIT_X86 0
#endif

namespace gabarit {

// Whether this is the GPU's code of a function that both have.
inline constexpr bool on_gpu = GABARIT_ON_GPU != 0;

// The number of the lowest bit that is set; there must be one.
GABARIT_HD inline int lowest_bit(unsigned bits) {
#if GABARIT_ON_GPU
  return __ffs(static_cast<int>(bits)) - 1;
#else
  return __builtin_ctz(bits);
#endif
}

}  // namespace gabarit
