#include "checks/local_sag.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

// Bends under this are rounding of float coordinates, radians.
constexpr double flat = 1e-5;
// Quads that grow narrow, as towards the pole of a ball, lie up to 2 % further off than their rows would.
constexpr double allowance = 1.05;

// Height of a facet over one of its edges.
double width(const TriangleMesh& mesh, FacetId f, int edge) {
  const Vec3d a = mesh.corner(f, edge), b = mesh.corner(f, (edge + 1) % 3);
  const double base = length(b - a);
  return base > 0 ? 2 * facet_area(mesh, f) / base : 0;
}

// Of a chord that is `own` wide, when the next chord of the same circle is `other` wide and bends by `angle`.
double sagitta(double own, double other, double angle) {
  const double half = std::atan2(own * std::sin(angle), other + own * std::cos(angle));  // of its arc
  return own / 2 * std::tan(half / 2);
}

// Of two unit normals; exactly zero where they are surely less than `flat` apart.
double bend(const Vec3d& m, const Vec3d& n) {
  const double across = length(cross(m, n)), along = dot(m, n);
  return across < 0.5 * flat && along > 0.9 ? 0 : std::atan2(across, along);
}

float sag_of(const TriangleMesh& mesh, std::span<const Vec3d> normals, const Adjacency& adjacency, FacetId f,
             double crease, double declared) {
  const Vec3d normal = normals[f];
  if (normal == Vec3d{}) return 0;
  std::array<double, 3> across{};
  for (const EdgeNeighbour& edge : adjacency.of(f)) {
    const double angle = bend(normal, normals[edge.facet]);
    if (angle > crease || angle < flat) continue;
    const double other = width(mesh, edge.facet, edge.other);
    const double own = std::min(width(mesh, f, edge.edge), 2 * other);
    double& most = across[edge.edge];
    if (own > 0) most = std::max(most, sagitta(own, other, angle));
  }
  return static_cast<float>(std::min(declared, allowance * (across[0] + across[1] + across[2])));
}

// A quad that is cut into two facets in one plane lies off the surface as a whole.
float greatest_of_quad(std::span<const Vec3d> normals, const Adjacency& adjacency, FacetId f,
                       const std::vector<float>& sag) {
  float greatest = sag[f];
  if (!(greatest > 0)) return greatest;
  for (const EdgeNeighbour& edge : adjacency.of(f)) {
    if (bend(normals[f], normals[edge.facet]) < flat) greatest = std::max(greatest, sag[edge.facet]);
  }
  return greatest;
}

}  // namespace

std::vector<float> local_sag(const TriangleMesh& mesh, std::span<const Vec3d> normals,
                             const Adjacency& adjacency, double crease, double declared,
                             const Device& device) {
  std::vector<float> sag(mesh.facet_count()), of_quad(sag.size());
  const auto for_each_facet = [&](const auto& work) {
    parallel_for_cpu(
        device, static_cast<std::int64_t>(sag.size()), [&](std::int64_t i) { work(static_cast<FacetId>(i)); },
        8192);
  };
  for_each_facet([&](FacetId f) { sag[f] = sag_of(mesh, normals, adjacency, f, crease, declared); });
  for_each_facet([&](FacetId f) { of_quad[f] = greatest_of_quad(normals, adjacency, f, sag); });
  return of_quad;
}

}  // namespace gabarit
