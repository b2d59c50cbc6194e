// One way for all queries of a tree: where the tree is, in as large batches as its device has room for.
#pragma once

#include <span>

#include "gpu/batches.h"
#include "gpu/buffer.h"
#include "gpu/bvh.h"
#include "gpu/parallel_for.h"

namespace gabarit {

// kernel(queries, answers) makes the kernel for two views of the same length, of which one index answers
// `run` queries in a row. `grain`: of the CPU, in indices.
template <class Query, class Answer, class MakeKernel>
void answer_queries(const Bvh& tree, std::span<const Query> queries, std::span<Answer> answers,
                    std::int64_t run, std::int64_t grain, MakeKernel&& kernel) {
  const Device& device = tree.device();
  const auto n = static_cast<std::int64_t>(queries.size());
  const auto indices = [run](std::int64_t count) { return (count + run - 1) / run; };
  if (!device.has_own_memory())
    return parallel_for(device, indices(n), kernel(view(queries), view(answers)), grain);
  in_batches(n, run, [&](std::int64_t begin, std::int64_t end) {
    const auto first = static_cast<std::size_t>(begin), count = static_cast<std::size_t>(end - begin);
    const Buffer<Query> asked(device, queries.subspan(first, count));
    auto found = Buffer<Answer>::of_size(device, end - begin);
    parallel_for(device, indices(end - begin), kernel(asked.view(), found.view()), grain);
    found.read(answers.subspan(first, count));
  });
}

}  // namespace gabarit
