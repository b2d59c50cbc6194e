// Queries from exact surfaces in the order in which a device answers them best.
#pragma once

#include <span>
#include <vector>

#include "checks/exact_model.h"

namespace gabarit {

// Calls work(queries, answers) with the queries sorted by the kind of surface that they start on, then face
// by face, those of one face as they came: threads side by side do the same things on the same faces. Answers
// come back in the order of the caller. Queries have a `face`.
template <class Query, class Answer, class Work>
void face_by_face(const ExactModel& model, std::span<const Query> queries, std::span<Answer> answers,
                  Work&& work) {
  const std::vector<std::uint32_t>& order = model.order_of_faces();
  std::vector<std::size_t> next(order.size() + 1, 0);
  for (const Query& q : queries) ++next[order[q.face] + 1];
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<std::size_t> place(queries.size());
  std::vector<Query> sorted(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    place[i] = next[order[queries[i].face]]++;
    sorted[place[i]] = queries[i];
  }
  std::vector<Answer> found(queries.size());
  work(std::span<const Query>(sorted), std::span<Answer>(found));
  for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = found[place[i]];
}

}  // namespace gabarit
