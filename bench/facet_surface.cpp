#include "bench/facet_surface.h"

#include <ctime>

namespace gabarit {

FacetSurface facet_surface(const TriangleMesh& mesh) {
  FacetSurface surface;
  surface.points = mesh.vertices;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const Vec3d n = facet_normal(mesh, f);
    if (n == Vec3d{}) continue;
    surface.primitives.push_back(
        {mesh.facets[f], f, {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)}, 0});
  }
  return surface;
}

std::vector<SphereQuery> inward_queries(const TriangleMesh& mesh, const Bvh& tree) {
  std::vector<SphereQuery> queries;
  for (const std::uint32_t f : tree.order())
    queries.push_back({mesh.centroid(f), -facet_normal(mesh, f), f, 0, 0, 0});
  return queries;
}

SphereOptions paper_definition(const TriangleMesh& mesh) {
  return {.cos_separation = 1, .contact_floor = 1e-6 * length(bounding_box(mesh).extent())};
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace gabarit
