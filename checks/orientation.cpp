#include "checks/orientation.h"

#include <algorithm>
#include <cmath>

#include "gpu/parallel_for.h"

namespace gabarit {

namespace {

struct Sums {
  Vec3d area;
  double total = 0, volume = 0;

  void add(const Sums& other) {
    area += other.area;
    total += other.total;
    volume += other.volume;
  }
};

// Blocks of one size, so that the sums do not depend on the threads.
constexpr std::size_t block = 1 << 15;

Vec3d some_point(const TriangleMesh& mesh) {
  const auto p =
      std::find_if(mesh.vertices.begin(), mesh.vertices.end(), [](const Vec3d& v) { return is_finite(v); });
  return p == mesh.vertices.end() ? Vec3d{} : *p;
}

void add_facets(const TriangleMesh& mesh, const Vec3d& origin, std::size_t begin, std::vector<Sums>& sums) {
  const std::size_t end = std::min(begin + block, mesh.facet_count());
  for (std::size_t i = begin; i < end; ++i) {
    const auto f = static_cast<FacetId>(i);
    const auto [a, b, c] = mesh.corners(f);
    const Vec3d area = 0.5 * cross(b - a, c - a);
    if (is_finite(area)) sums[mesh.body_of(f)].add({area, length(area), dot(area, a - origin) / 3});
  }
}

}  // namespace

std::vector<std::uint32_t> inside_out_bodies(const TriangleMesh& mesh, const Device& device) {
  const std::size_t bodies =
      mesh.body.empty() ? 1 : 1 + std::size_t{*std::max_element(mesh.body.begin(), mesh.body.end())};
  const Vec3d origin = some_point(mesh);
  // Many bodies: one block, or the sums would outgrow the mesh.
  const std::size_t blocks = bodies > 64 ? 1 : (mesh.facet_count() + block - 1) / block;
  std::vector<std::vector<Sums>> parts(blocks, std::vector<Sums>(bodies));
  const auto kernel = [&](std::int64_t i) {
    const auto part = static_cast<std::size_t>(i);
    for (std::size_t begin = part * block; begin < mesh.facet_count(); begin += blocks * block) {
      add_facets(mesh, origin, begin, parts[part]);
    }
  };
  parallel_for_cpu(device, static_cast<std::int64_t>(blocks), kernel, 1);
  std::vector<std::uint32_t> found;
  for (std::size_t body = 0; body < bodies; ++body) {
    Sums s;
    for (const std::vector<Sums>& part : parts) s.add(part[body]);
    const double noise = 1e-6 * s.total;
    if (length(s.area) <= noise && s.volume < -noise * std::sqrt(s.total))
      found.push_back(static_cast<std::uint32_t>(body));
  }
  return found;
}

}  // namespace gabarit
