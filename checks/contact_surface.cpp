#include "checks/contact_surface.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <span>
#include <utility>

#include "checks/contact_features.h"
#include "checks/local_sag.h"
#include "gpu/parallel_for.h"
#include "model/facet_normals.h"
#include "model/smooth_normals.h"

namespace gabarit {
namespace {

constexpr std::int64_t grain = 8192;

Vec3f to_float(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

FacetSurface facets_of(const TriangleMesh& mesh, std::span<const Vec3d> normals,
                       const std::vector<float>& sag, Side side, const Device& device) {
  FacetSurface surface;
  surface.points = mesh.vertices;
  surface.primitives.resize(mesh.facet_count());
  parallel_for_cpu(
      device, static_cast<std::int64_t>(normals.size()),
      [&](std::int64_t i) {
        const auto f = static_cast<FacetId>(i);
        surface.primitives[f] = {mesh.facets[f], f, to_float(side == Side::inside ? normals[f] : -normals[f]),
                                 sag[f]};
      },
      grain);
  std::erase_if(surface.primitives, [](const Primitive& p) { return !p.is_facet(); });
  return surface;
}

// Whether every edge of a facet with a normal is shared, also through T-junctions, where neighbours share an
// edge among them.
bool is_closed_at(const Adjacency& adjacency, FacetId f) {
  std::array<double, 3> covered{};
  for (const EdgeNeighbour& edge : adjacency.of(f)) {
    if (!edge.reversed) return false;
    covered[edge.edge] += static_cast<double>(edge.to) - static_cast<double>(edge.from);
  }
  return *std::min_element(covered.begin(), covered.end()) >= 0.999;
}

bool is_closed(std::span<const Vec3d> normals, const Adjacency& adjacency, const Device& device) {
  std::atomic<bool> closed = true;
  parallel_for_cpu(
      device, static_cast<std::int64_t>(normals.size()),
      [&](std::int64_t i) {
        const auto f = static_cast<FacetId>(i);
        if (normals[f] != Vec3d{} && !is_closed_at(adjacency, f))
          closed.store(false, std::memory_order_relaxed);
      },
      grain);
  return closed;
}

}  // namespace

ContactSurface contact_surface(const TriangleMesh& mesh, const Adjacency& adjacency,
                               const SurfaceOptions& options, const Device& device) {
  const std::vector<Vec3d> normals = facet_normals(mesh, device);
  std::vector<float> sag = local_sag(mesh, normals, adjacency, options.crease, options.sag, device);
  FacetSurface surface = facets_of(mesh, normals, sag, options.side, device);
  add_features(surface, mesh, normals, adjacency, sag, options.side);
  return {Bvh(device, std::move(surface)), smooth_normals(mesh, normals, options.crease, device),
          std::move(sag), length(bounding_box(mesh).extent()), is_closed(normals, adjacency, device)};
}

}  // namespace gabarit
