#include "checks/exact_ball.h"

#include <algorithm>

#include "checks/exact_ball_search.h"
#include "gpu/parallel_for.h"
#include "gpu/traverse.h"

namespace gabarit {
namespace {

// A short run of queries, each starting from what the one before found; runs do not depend on the threads.
struct ExactBallRuns {
  static constexpr std::int64_t length = 32;

  ExactView view;
  ExactBallOptions options;
  View<const ExactBallQuery> queries;
  View<ExactBall> balls;

  GABARIT_HD void operator()(std::int64_t run) const {
    const std::int64_t first = run * length;
    const std::int64_t end = first + length < queries.size ? first + length : queries.size;
    for (std::int64_t i = first; i < end; ++i) {
      ExactBallSearch search(view, options, queries[i]);
      if (i > first) search.begin_at(balls[i - 1]);
      traverse(view.tree, search);
      balls[i] = search.result();
    }
  }
};

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

void exact_balls(const Device& device, const ExactSurface& surface, const ExactBallOptions& options,
                 std::span<const ExactBallQuery> queries, std::span<ExactBall> balls) {
  ExactBallOptions bounded = options;
  bounded.greatest_radius = std::min(options.greatest_radius, 4 * surface.size + 1e-30);
  const auto runs =
      (static_cast<std::int64_t>(queries.size()) + ExactBallRuns::length - 1) / ExactBallRuns::length;
  const ExactBallRuns kernel{surface.view(), bounded, view(queries), view(balls)};
  parallel_for_cpu(device, runs, kernel, 4);
}

}  // namespace gabarit
