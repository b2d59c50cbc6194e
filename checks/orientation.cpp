#include "checks/orientation.h"

#include <algorithm>

namespace gabarit {

namespace {

struct Sums {
  Vec3d area;
  double total = 0, volume = 0;
};

}  // namespace

std::vector<std::uint32_t> inside_out_bodies(const TriangleMesh& mesh) {
  const std::uint32_t bodies =
      mesh.body.empty() ? 1 : 1 + *std::max_element(mesh.body.begin(), mesh.body.end());
  const Vec3d middle = bounding_box(mesh).centre();
  std::vector<Sums> sums(bodies);
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const auto [a, b, c] = mesh.corners(f);
    const Vec3d area = 0.5 * cross(b - a, c - a);
    if (!is_finite(area)) continue;
    Sums& s = sums[mesh.body_of(f)];
    s.area += area;
    s.total += length(area);
    s.volume += dot(area, a - middle) / 3;
  }
  std::vector<std::uint32_t> found;
  for (std::uint32_t body = 0; body < bodies; ++body) {
    const Sums& s = sums[body];
    const double noise = 1e-6 * s.total;
    if (length(s.area) <= noise && s.volume < -noise * std::sqrt(s.total)) found.push_back(body);
  }
  return found;
}

}  // namespace gabarit
