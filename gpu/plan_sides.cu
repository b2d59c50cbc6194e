#include "gpu/parallel_for.h"
#include "gpu/plan_sides.h"
#include "gpu/prefix_sums.h"

namespace gabarit {
namespace {

// The sign of a product is exact when it is told from the signs of its factors.
GABARIT_HD int sign_of_product(double a, double b) {
  if (a == 0 || b == 0) return 0;
  return (a < 0) == (b < 0) ? 1 : -1;
}

// 1 when c lies left of the line from a to b, -1 right, 0 on it, or doubtful (Shewchuk, Adaptive Precision
// Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997: the first filter).
GABARIT_HD int side_of(Point2 a, Point2 b, Point2 c) {
  const Point2 p = a - c, q = b - c;
  const int left = sign_of_product(p.x, q.y), right = sign_of_product(p.y, q.x);
  if (left != right || left == 0) return left != 0 ? left : -right;
  const double x = p.x * q.y, y = p.y * q.x;
  const double magnitude = std::abs(x) + std::abs(y);
  constexpr double filter = 3.3306690738754716e-16;
  constexpr double least = 1e-280;  // far from where products lose digits
  if (!(magnitude > least) || !(std::abs(x - y) > filter * magnitude)) return doubtful_turn;
  return x > y ? 1 : -1;
}

// Which side of its side i the polygon lies on; 0 when it projects to the side itself.
GABARIT_HD int turn_of(const PlanPolygon& polygon, int i) {
  for (int k = 2; k < polygon.size; ++k) {
    const int far = i + k < polygon.size ? i + k : i + k - polygon.size;
    const int side = side_of(polygon.corner[i], polygon.next(i), polygon.corner[far]);
    if (side != 0) return side;
  }
  return 0;
}

struct CountSides {
  PlanMesh mesh;
  View<const std::uint32_t> facets;
  View<std::uint32_t> counts;

  GABARIT_HD void operator()(std::int64_t i) const {
    const std::array<std::uint32_t, 3>& f = mesh.facets[facets[i]];
    const bool whole =
        mesh.holds(mesh.points[f[0]]) && mesh.holds(mesh.points[f[1]]) && mesh.holds(mesh.points[f[2]]);
    counts[i] = whole ? 3 : static_cast<std::uint32_t>(mesh.polygon(facets[i]).size);
  }
};

struct WriteSides {
  PlanMesh mesh;
  View<const std::uint32_t> facets;
  View<const std::uint32_t> first;  // by facet of the list, among all sides
  View<PlanSide> sides;

  GABARIT_HD void operator()(std::int64_t i) const {
    const PlanPolygon polygon = mesh.polygon(facets[i]);
    for (int k = 0; k < polygon.size; ++k)
      sides[first[i] + k] = {polygon.corner[k], polygon.next(k), facets[i], polygon.edge[k],
                             turn_of(polygon, k)};
  }
};

}  // namespace

std::vector<PlanSide> plan_sides(const Device& device, const PlanMesh& mesh,
                                 std::span<const std::uint32_t> facets) {
  constexpr std::int64_t grain = 4096;
  const auto n = static_cast<std::int64_t>(facets.size());
  const Buffer<std::uint32_t> list(device, facets);
  auto counts = Buffer<std::uint32_t>::of_size(device, n);
  parallel_for(device, n, CountSides{mesh, list.view(), counts.view()}, grain);
  const PrefixSums sums = prefix_sums(device, counts);
  auto sides = Buffer<PlanSide>::of_size(device, sums.total);
  parallel_for(device, n, WriteSides{mesh, list.view(), sums.before.view(), sides.view()}, grain);
  return std::move(sides).read();
}

}  // namespace gabarit
