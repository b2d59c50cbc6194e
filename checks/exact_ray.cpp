#include "checks/exact_ray.h"

#include "checks/exact_ray_search.h"
#include "gpu/parallel_for.h"

namespace gabarit {

void exact_rays(const Device& device, const ExactRayScene& scene, const ExactRayOptions& options,
                std::span<const ExactRayQuery> queries, std::span<ExactRay> rays) {
  ExactRayOptions bounded = options;
  bounded.greatest = std::min(options.greatest, 4.0 * static_cast<double>(scene.facets.reach) + 1e-30);
  const auto kernel = [&](std::int64_t i) {
    const auto at = static_cast<std::size_t>(i);
    ExactRaySearch search(scene, bounded, queries[at]);
    traverse(scene.facets, search);
    rays[at] = search.result();
  };
  parallel_for_cpu(device, static_cast<std::int64_t>(queries.size()), kernel, 64);
}

std::vector<double> face_reaches(const Brep& brep) {
  std::vector<double> reaches(brep.faces.size(), 0);
  for (FaceId f = 0; f < brep.faces.size(); ++f) {
    for (std::uint32_t i = brep.first_edge_of_face[f]; i < brep.first_edge_of_face[f + 1]; ++i) {
      const Edge& edge = brep.edges[brep.edges_of_face[i]];
      reaches[f] = std::max(reaches[f], 2 * edge.tolerance);
      for (const std::uint32_t v : edge.vertices)
        if (v != no_number) reaches[f] = std::max(reaches[f], 2 * brep.vertices[v].tolerance);
    }
  }
  return reaches;
}

}  // namespace gabarit
