#include <algorithm>

#include "checks/exact_ray.h"
#include "checks/exact_ray_search.h"
#include "checks/face_order.h"
#include "gpu/answer_queries.h"

namespace gabarit {
namespace {

struct ExactRayBatch {
  ExactRayView view;
  ExactRayOptions options;
  View<const ExactRayQuery> queries;
  View<ExactRay> rays;

  template <VectorSet set>
  GABARIT_HD void run(std::int64_t i) const {
    ExactRaySearch search(view, options, queries[i]);
    traverse<set>(view.tree, search);
    rays[i] = search.result();
  }
};

}  // namespace

void exact_rays(const Bvh& tree, const ExactModel& exact, const ExactRayOptions& options,
                std::span<const ExactRayQuery> queries, std::span<ExactRay> rays) {
  const ExactRayView there{exact.view(), tree.view()};
  ExactRayOptions bounded = options;
  bounded.greatest = std::min(options.greatest, 4.0 * static_cast<double>(there.tree.reach) + 1e-30);
  face_by_face(exact, queries, rays, [&](std::span<const ExactRayQuery> asked, std::span<ExactRay> found) {
    answer_queries(tree, asked, found, 1, 64, [&](View<const ExactRayQuery> q, View<ExactRay> answers) {
      return ExactRayBatch{there, bounded, q, answers};
    });
  });
}

}  // namespace gabarit
