#include "model/smooth_normals.h"

#include <algorithm>
#include <cmath>

#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

// Facets with a normal by vertex.
class Stars {
 public:
  Stars(const TriangleMesh& mesh, std::span<const Vec3d> normals) : first_(mesh.vertices.size() + 1, 0) {
    for (FacetId f = 0; f < mesh.facet_count(); ++f) {
      if (normals[f] == Vec3d{}) continue;
      for (const VertexId v : mesh.facets[f]) ++first_[v + 1];
    }
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    half_edges_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (FacetId f = 0; f < mesh.facet_count(); ++f) {
      if (normals[f] == Vec3d{}) continue;
      for (std::uint32_t i = 0; i < 3; ++i) half_edges_[next[mesh.facets[f][i]]++] = 3 * f + i;
    }
  }

  template <class Visit>
  void for_each(VertexId v, Visit&& visit) const {
    for (std::uint32_t i = first_[v]; i < first_[v + 1]; ++i) visit(half_edges_[i] / 3, half_edges_[i] % 3);
  }

 private:
  std::vector<std::uint32_t> first_, half_edges_;
};

double weight(const TriangleMesh& mesh, FacetId f, std::size_t corner) {
  const Vec3d at = mesh.corner(f, static_cast<int>(corner));
  const Vec3d u = mesh.corner(f, static_cast<int>((corner + 1) % 3)) - at;
  const Vec3d v = mesh.corner(f, static_cast<int>((corner + 2) % 3)) - at;
  const double area = length(cross(u, v));
  return area * std::atan2(area, dot(u, v));
}

Vec3f to_float(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace

std::vector<std::array<Vec3f, 3>> smooth_normals(const TriangleMesh& mesh, std::span<const Vec3d> normals,
                                                 double crease, const Device& device) {
  const auto count = static_cast<std::int64_t>(mesh.facet_count());
  std::vector<std::array<double, 3>> weights(mesh.facet_count());
  parallel_for_cpu(
      device, count,
      [&](std::int64_t i) {
        const auto f = static_cast<FacetId>(i);
        for (std::size_t k = 0; k < 3; ++k) weights[f][k] = weight(mesh, f, k);
      },
      8192);
  const Stars stars(mesh, normals);
  const double least = std::cos(crease);
  std::vector<std::array<Vec3f, 3>> corners(mesh.facet_count());
  parallel_for_cpu(
      device, count,
      [&](std::int64_t i) {
        const auto f = static_cast<FacetId>(i);
        const Vec3d own = normals[f];
        if (own == Vec3d{}) return;
        for (std::size_t k = 0; k < 3; ++k) {
          Vec3d sum;
          stars.for_each(mesh.facets[f][k], [&](FacetId g, std::uint32_t corner) {
            if (g == f || dot(own, normals[g]) >= least) sum += weights[g][corner] * normals[g];
          });
          const Vec3d mean = normalized(sum);
          corners[f][k] = to_float(mean == Vec3d{} ? own : mean);
        }
      },
      4096);
  return corners;
}

}  // namespace gabarit
