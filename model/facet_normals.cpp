#include "model/facet_normals.h"

#include "gpu/parallel_for.h"

namespace gabarit {

std::vector<Vec3d> facet_normals(const TriangleMesh& mesh, const Device& device) {
  std::vector<Vec3d> normals(mesh.facet_count());
  parallel_for_cpu(
      device, static_cast<std::int64_t>(normals.size()),
      [&](std::int64_t f) {
        normals[static_cast<std::size_t>(f)] = facet_normal(mesh, static_cast<FacetId>(f));
      },
      8192);
  return normals;
}

}  // namespace gabarit
