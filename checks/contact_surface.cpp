#include "checks/contact_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "checks/contact_features.h"
#include "checks/local_sag.h"
#include "model/smooth_normals.h"

namespace gabarit {
namespace {

Vec3f to_float(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

FacetSurface facets_of(const TriangleMesh& mesh, const std::vector<float>& sag, Side side) {
  FacetSurface surface;
  surface.points = mesh.vertices;
  surface.primitives.reserve(mesh.facet_count());
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const Vec3d normal = facet_normal(mesh, f);
    if (normal == Vec3d{}) continue;
    surface.primitives.push_back(
        {mesh.facets[f], f, to_float(side == Side::inside ? normal : -normal), sag[f]});
  }
  return surface;
}

// Through T-junctions: neighbours may share an edge among them.
bool is_closed(const TriangleMesh& mesh, const Adjacency& adjacency) {
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    if (facet_normal(mesh, f) == Vec3d{}) continue;
    std::array<double, 3> covered{};
    for (const EdgeNeighbour& edge : adjacency.of(f)) {
      if (!edge.reversed) return false;
      covered[edge.edge] += static_cast<double>(edge.to) - static_cast<double>(edge.from);
    }
    if (*std::min_element(covered.begin(), covered.end()) < 0.999) return false;
  }
  return true;
}

}  // namespace

ContactSurface contact_surface(const TriangleMesh& mesh, const Adjacency& adjacency,
                               const SurfaceOptions& options, const Device& device) {
  std::vector<float> sag = local_sag(mesh, adjacency, options.crease, options.sag, device);
  FacetSurface surface = facets_of(mesh, sag, options.side);
  add_features(surface, mesh, adjacency, sag, options.side);
  return {Bvh(device, std::move(surface)), smooth_normals(mesh, options.crease, device), std::move(sag),
          length(bounding_box(mesh).extent()), is_closed(mesh, adjacency)};
}

}  // namespace gabarit
