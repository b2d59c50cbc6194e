// Marks functions that run on the CPU and on the GPU. One of the three files that may ask which compiler
// reads them.
#pragma once

#if defined(__CUDACC__)
#define GABARIT_HD __host__ __device__
#else
#define GABARIT_HD
#endif
