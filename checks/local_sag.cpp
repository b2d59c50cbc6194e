#include "checks/local_sag.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

// Bends under this are rounding of float coordinates, radians.
constexpr double flat = 1e-5;

// Height of a facet over one of its edges.
double width(const TriangleMesh& mesh, FacetId f, int edge) {
  const Vec3d a = mesh.corner(f, edge), b = mesh.corner(f, (edge + 1) % 3);
  const double base = length(b - a);
  return base > 0 ? 2 * facet_area(mesh, f) / base : 0;
}

double bend(const Vec3d& m, const Vec3d& n) { return std::atan2(length(cross(m, n)), dot(m, n)); }

float sag_of(const TriangleMesh& mesh, const Adjacency& adjacency, FacetId f, double crease,
             double declared) {
  const Vec3d normal = facet_normal(mesh, f);
  if (normal == Vec3d{}) return 0;
  std::array<double, 3> across{};
  for (const EdgeNeighbour& edge : adjacency.of(f)) {
    const double angle = bend(normal, facet_normal(mesh, edge.facet));
    if (angle > crease || angle < flat) continue;
    const double other = width(mesh, edge.facet, edge.other);
    const double own = std::min(width(mesh, f, edge.edge), 2 * other);
    double& most = across[edge.edge];
    if (own > 0) most = std::max(most, angle * own * own / (4 * (own + other)));
  }
  return static_cast<float>(std::min(declared, across[0] + across[1] + across[2]));
}

}  // namespace

std::vector<float> local_sag(const TriangleMesh& mesh, const Adjacency& adjacency, double crease,
                             double declared, const Device& device) {
  std::vector<float> sag(mesh.facet_count());
  parallel_for_cpu(
      device, static_cast<std::int64_t>(sag.size()),
      [&](std::int64_t i) {
        const auto f = static_cast<FacetId>(i);
        sag[f] = sag_of(mesh, adjacency, f, crease, declared);
      },
      8192);
  return sag;
}

}  // namespace gabarit
