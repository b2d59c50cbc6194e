#include "gpu/parallel_for.h"

#include <algorithm>

#ifdef GABARIT_HAS_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#else
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#endif

namespace gabarit {

using Body = void (*)(void*, std::int64_t, std::int64_t);

#ifdef GABARIT_HAS_TBB
void run_chunks(int threads, std::int64_t n, std::int64_t grain, void* context, Body body) {
  if (n <= 0) return;
  if (threads == 1 || n <= grain) return body(context, 0, n);
  const int cores = tbb::this_task_arena::max_concurrency();
  tbb::task_arena arena(threads > 0 ? std::min(threads, cores) : cores);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, n, static_cast<std::size_t>(grain)),
                      [&](const auto& range) { body(context, range.begin(), range.end()); });
  });
}
#else
void run_chunks(int threads, std::int64_t n, std::int64_t grain, void* context, Body body) {
  if (n <= 0) return;
  const auto cores =
      static_cast<std::int64_t>(threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency()));
  const std::int64_t workers = std::min(cores, (n + grain - 1) / grain);
  if (workers == 1) return body(context, 0, n);
  std::atomic<std::int64_t> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto work = [&] {
    try {
      for (std::int64_t begin = next.fetch_add(grain); begin < n; begin = next.fetch_add(grain))
        body(context, begin, std::min(begin + grain, n));
    } catch (...) {
      const std::lock_guard lock(guard);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> team;
    for (std::int64_t i = 1; i < workers; ++i) team.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}
#endif

}  // namespace gabarit
