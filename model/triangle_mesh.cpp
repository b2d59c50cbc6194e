#include "model/triangle_mesh.h"

namespace gabarit {

Vec3d facet_normal(const TriangleMesh& mesh, FacetId f) {
  const auto [a, b, c] = mesh.corners(f);
  const Vec3d u = b - a;
  const Vec3d v = c - a;
  const Vec3d n = cross(u, v);
  // Written so that NaN ends here too.
  if (!(squared_length(n) > 1e-20 * squared_length(u) * squared_length(v)) || !is_finite(n)) return {};
  return normalized(n);
}

double facet_area(const TriangleMesh& mesh, FacetId f) {
  const auto [a, b, c] = mesh.corners(f);
  const double area = 0.5 * length(cross(b - a, c - a));
  return std::isfinite(area) ? area : 0.0;
}

Box3d bounding_box(const TriangleMesh& mesh) {
  Box3d box;
  for (const auto& facet : mesh.facets) {
    for (const VertexId v : facet) {
      if (is_finite(mesh.vertices[v])) box.add(mesh.vertices[v]);
    }
  }
  return box;
}

}  // namespace gabarit
