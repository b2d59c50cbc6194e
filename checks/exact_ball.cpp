#include "checks/exact_ball.h"

#include "checks/exact_ball_search.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

// A short run of queries, each starting from what the one before found; runs do not depend on the threads.
struct ExactBallRuns {
  static constexpr std::int64_t length = 32;

  const ExactBallScene& scene;
  const ExactBallOptions& options;
  std::span<const ExactBallQuery> queries;
  std::span<ExactBall> balls;

  void operator()(std::int64_t run) const {
    const auto begin = static_cast<std::size_t>(run * length);
    const std::size_t end = std::min(begin + static_cast<std::size_t>(length), queries.size());
    for (std::size_t i = begin; i < end; ++i) {
      ExactBallSearch search(scene, options, queries[i]);
      if (i > begin) search.warm_up(balls[i - 1]);
      search.run();
      balls[i] = search.ball;
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

void exact_balls(const Device& device, const ExactBallScene& scene, const ExactBallOptions& options,
                 std::span<const ExactBallQuery> queries, std::span<ExactBall> balls) {
  ExactBallOptions bounded = options;
  bounded.greatest_radius =
      std::min(options.greatest_radius, 4.0 * static_cast<double>(scene.facets.reach) + 1e-30);
  const auto runs =
      (static_cast<std::int64_t>(queries.size()) + ExactBallRuns::length - 1) / ExactBallRuns::length;
  parallel_for_cpu(device, runs, ExactBallRuns{scene, bounded, queries, balls}, 4);
}

}  // namespace gabarit
