// Runs a kernel for every index of a range. A kernel is a trivially copyable struct of views with
// `void operator()(std::int64_t i) const`, free of side effects on other indices: the result does not depend
// on the order.
#pragma once

#include <cstdint>

#include "gpu/device.h"

namespace gabarit {

// Calls body(context, begin, end) for disjoint chunks that cover [0, n), on at most `threads` threads (0: all
// cores).
void run_chunks(int threads, std::int64_t n, std::int64_t grain, void* context,
                void (*body)(void* context, std::int64_t begin, std::int64_t end));

// Throws what a kernel throws. `grain`: how many indices are worth a hand-over to another thread.
template <class Kernel>
void parallel_for(const Device& device, std::int64_t n, const Kernel& kernel, std::int64_t grain = 1024) {
  run_chunks(device.threads, n, grain, const_cast<Kernel*>(&kernel),
             [](void* context, std::int64_t begin, std::int64_t end) {
               const Kernel& k = *static_cast<const Kernel*>(context);
               for (std::int64_t i = begin; i < end; ++i) k(i);
             });
}

}  // namespace gabarit
