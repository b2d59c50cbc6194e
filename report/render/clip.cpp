#include "report/render/clip.h"

#include <utility>

namespace gabarit {

// Where the segment crosses; the same for both directions.
static Vec3d crossing(Vec3d a, Vec3d b, int axis, double at) {
  if (in_order(b, a)) std::swap(a, b);
  // Halves: the difference of two huge numbers could overflow.
  const double t = (at / 2 - a[axis] / 2) / (b[axis] / 2 - a[axis] / 2);
  Vec3d cut = a * (1 - t) + b * t;
  cut[axis] = at;
  return cut;
}

// Keeps what lies at `at` or on the side that `sign` points to.
static std::vector<Vec3d> half(const std::vector<Vec3d>& polygon, int axis, double at, double sign) {
  std::vector<Vec3d> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d& a = polygon[i];
    const Vec3d& b = polygon[(i + 1) % polygon.size()];
    const bool a_in = sign * (a[axis] - at) >= 0;
    const bool b_in = sign * (b[axis] - at) >= 0;
    if (a_in) kept.push_back(a);
    if (a_in != b_in) kept.push_back(crossing(a, b, axis, at));
  }
  return kept;
}

std::vector<Vec3d> clipped(std::vector<Vec3d> polygon, double left, double top, double right, double bottom) {
  polygon = half(polygon, 0, left, 1);
  polygon = half(polygon, 0, right, -1);
  polygon = half(polygon, 1, top, 1);
  return half(polygon, 1, bottom, -1);
}

}  // namespace gabarit
