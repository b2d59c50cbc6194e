#include <algorithm>

#include "gpu/answer_queries.h"
#include "gpu/maximal_sphere.h"
#include "gpu/maximal_sphere_kernel.h"
#include "gpu/sphere_lower_bound.h"
#include "gpu/traverse.h"

namespace gabarit {
namespace {

// One index is a short run of queries, each starting from the contact of the one before. The runs do not
// depend on the number of threads.
struct SphereRuns {
  static constexpr std::int64_t length = 32;

  BvhView tree;
  SphereOptions options;
  View<const SphereQuery> queries;
  View<SphereContact> contacts;

  GABARIT_HD bool is_loose(const SphereQuery& q) const {
    return q.sag > 0 || q.spacing > 0 || q.tilt > 0 || tree.greatest_sag > 0;
  }
  template <VectorSet set>
  GABARIT_HD double lower_bound(const SphereQuery& query, double known, const Primitive* contact) const {
    SphereLowerBound bound(tree, options, query, known);
    if (contact != nullptr) bound.start_from(*contact);
    traverse<set>(tree, bound);
    return bound.result();
  }

  template <VectorSet set>
  GABARIT_HD void run(std::int64_t index) const {
    const Primitive* guess = nullptr;
    const std::int64_t end = (index + 1) * length < queries.size ? (index + 1) * length : queries.size;
    for (std::int64_t i = index * length; i < end; ++i) {
      MaximalSphere sphere(tree, options, queries[i]);
      if (guess != nullptr) sphere.start_from(*guess);
      traverse<set>(tree, sphere);
      contacts[i] = sphere.result();
      if (is_loose(queries[i]))
        contacts[i].lower = lower_bound<set>(queries[i], contacts[i].lower, sphere.touched());
      if (sphere.touched() != nullptr) guess = sphere.touched();
    }
  }
};

}  // namespace

void maximal_spheres(const Bvh& tree, const SphereOptions& options, std::span<const SphereQuery> queries,
                     std::span<SphereContact> contacts) {
  const BvhView view_of_tree = tree.view();
  SphereOptions bounded = options;
  bounded.greatest_radius =
      std::min(options.greatest_radius, 4.0 * static_cast<double>(view_of_tree.reach) + 1e-30);
  answer_queries(tree, queries, contacts, SphereRuns::length, 16,
                 [&](View<const SphereQuery> asked, View<SphereContact> answers) {
                   return SphereRuns{view_of_tree, bounded, asked, answers};
                 });
}

}  // namespace gabarit
