#include "model/polygon.h"

#include <numeric>

namespace gabarit {
namespace {

Vec3d newell_normal(std::span<const Vec3d> polygon) {
  Vec3d n;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    n += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  return n;
}

double turn(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& n) {
  return dot(cross(b - a, c - a), n);
}

bool is_ear(std::span<const Vec3d> polygon, const std::vector<std::size_t>& ring, std::size_t at,
            const Vec3d& n) {
  const std::size_t size = ring.size();
  const Vec3d& a = polygon[ring[(at + size - 1) % size]];
  const Vec3d& b = polygon[ring[at]];
  const Vec3d& c = polygon[ring[(at + 1) % size]];
  if (turn(a, b, c, n) <= 0) return false;
  for (std::size_t i = 0; i < size; ++i) {
    const Vec3d& p = polygon[ring[i]];
    if (p == a || p == b || p == c) continue;
    if (turn(a, b, p, n) >= 0 && turn(b, c, p, n) >= 0 && turn(c, a, p, n) >= 0) return false;
  }
  return true;
}

}  // namespace

std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec3d> polygon) {
  std::vector<std::array<std::size_t, 3>> triangles;
  if (polygon.size() < 3) return triangles;
  const Vec3d n = newell_normal(polygon);
  std::vector<std::size_t> ring(polygon.size());
  std::iota(ring.begin(), ring.end(), std::size_t{0});
  while (ring.size() > 3) {
    std::size_t ear = 1;  // taken when nothing is an ear: flat or self-crossing
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (is_ear(polygon, ring, i, n)) {
        ear = i;
        break;
      }
    }
    const std::size_t size = ring.size();
    triangles.push_back({ring[(ear + size - 1) % size], ring[ear], ring[(ear + 1) % size]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.push_back({ring[0], ring[1], ring[2]});
  return triangles;
}

}  // namespace gabarit
