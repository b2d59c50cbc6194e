#include <algorithm>

#include "checks/exact_ball.h"
#include "checks/exact_ball_search.h"
#include "checks/face_order.h"
#include "gpu/batches.h"
#include "gpu/parallel_for.h"
#include "gpu/traverse.h"

namespace gabarit {
namespace {

// Blocks of queries that lie side by side. In the first round the first query of each block is answered, in
// the next the one in its middle, then those in the middle between two answered ones, and so on; each starts
// from the contact of the nearer of the two. So the queries of a round are independent, half of all are in
// the last, and what a query starts from depends neither on threads nor on the device.
struct ExactBallRound {
  static constexpr std::int64_t block = 32;

  ExactView view;
  ExactBallOptions options;
  View<const ExactBallQuery> queries;
  View<ExactBall> balls;
  std::int64_t step = block;  // to the answered ones

  std::int64_t size() const {
    const std::int64_t first = step == block ? 0 : step, apart = step == block ? block : 2 * step;
    return queries.size > first ? (queries.size - first + apart - 1) / apart : 0;
  }

  template <VectorSet set>
  GABARIT_HD void run(std::int64_t number) const {
    const std::int64_t i = step == block ? number * block : (2 * number + 1) * step;
    ExactBallSearch search(view, options, queries[i]);
    if (step < block) search.begin_at(balls[nearer_answered(i)]);
    traverse<set>(view.tree, search);
    balls[i] = search.result();
  }

  GABARIT_HD std::int64_t nearer_answered(std::int64_t i) const {
    const std::int64_t before = i - step, after = i + step;
    if (after % block == 0 || after >= queries.size) return before;
    const auto away = [&](std::int64_t k) { return squared_length(queries[k].point - queries[i].point); };
    return away(before) <= away(after) ? before : after;
  }
};

void answer_in_rounds(const Device& device, ExactBallRound round) {
  for (; round.step > 0; round.step /= 2) parallel_for(device, round.size(), round, 32);
}

}  // namespace

const char* name(BallContact kind) {
  switch (kind) {
    case BallContact::none: break;
    case BallContact::face: return "face";
    case BallContact::edge: return "edge";
    case BallContact::vertex: return "vertex";
    case BallContact::curvature: return "own curvature";
    case BallContact::separation: return "limit of the separation angle";
  }
  return "nothing";
}

void exact_balls(const ExactSurface& surface, const ExactBallOptions& options,
                 std::span<const ExactBallQuery> queries, std::span<ExactBall> balls) {
  const Device& device = surface.tree.device();
  ExactBallOptions bounded = options;
  bounded.greatest_radius = std::min(options.greatest_radius, 4 * surface.size + 1e-30);
  const auto work = [&](std::span<const ExactBallQuery> asked, std::span<ExactBall> found) {
    if (!device.has_own_memory())
      return answer_in_rounds(device, {surface.view(), bounded, view(asked), view(found)});
    const auto n = static_cast<std::int64_t>(asked.size());
    in_batches(n, ExactBallRound::block, [&](std::int64_t begin, std::int64_t end) {
      const auto first = static_cast<std::size_t>(begin), count = static_cast<std::size_t>(end - begin);
      const Buffer<ExactBallQuery> there(device, asked.subspan(first, count));
      auto answers = Buffer<ExactBall>::of_size(device, end - begin);
      answer_in_rounds(device, {surface.view(), bounded, there.view(), answers.view()});
      answers.read(found.subspan(first, count));
    });
  };
  face_by_face(*surface.exact, queries, balls, work);
}

}  // namespace gabarit
