#include "gpu/batches.h"
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

// Of a mesh; one that was copied for the list holds no others.
struct ChosenFacets {
  PlanMesh mesh;
  View<const std::uint32_t> numbers;
  bool copied;

  GABARIT_HD std::int64_t place(std::int64_t i) const { return copied ? i : numbers[i]; }
};

struct CountSides {
  ChosenFacets chosen;
  View<std::uint32_t> counts;

  GABARIT_HD void operator()(std::int64_t i) const {
    const PlanMesh& mesh = chosen.mesh;
    const std::array<std::uint32_t, 3>& f = mesh.facets[chosen.place(i)];
    const bool whole =
        mesh.holds(mesh.points[f[0]]) && mesh.holds(mesh.points[f[1]]) && mesh.holds(mesh.points[f[2]]);
    counts[i] = whole ? 3 : static_cast<std::uint32_t>(mesh.polygon(chosen.place(i)).size);
  }
};

struct WriteSides {
  ChosenFacets chosen;
  View<const std::uint32_t> first;  // by facet of the list, among all sides
  View<PlanSide> sides;

  GABARIT_HD void operator()(std::int64_t i) const {
    const PlanPolygon polygon = chosen.mesh.polygon(chosen.place(i));
    for (int k = 0; k < polygon.size; ++k)
      sides[first[i] + k] = {polygon.corner[k], polygon.next(k), chosen.numbers[i], polygon.edge[k],
                             turn_of(polygon, k)};
  }
};

std::vector<PlanSide> sides_of(const Device& device, const ChosenFacets& chosen) {
  constexpr std::int64_t grain = 4096;
  const std::int64_t n = chosen.numbers.size;
  auto counts = Buffer<std::uint32_t>::of_size(device, n);
  parallel_for(device, n, CountSides{chosen, counts.view()}, grain);
  const PrefixSums sums = prefix_sums(device, counts);
  auto sides = Buffer<PlanSide>::of_size(device, sums.total);
  parallel_for(device, n, WriteSides{chosen, sums.before.view(), sides.view()}, grain);
  return std::move(sides).read();
}

}  // namespace

std::vector<PlanSide> plan_sides(const PlanFacets& plan, std::span<const std::uint32_t> facets) {
  std::vector<PlanSide> all;
  in_batches(
      static_cast<std::int64_t>(facets.size()), facets_of_a_copy, [&](std::int64_t begin, std::int64_t end) {
        const auto some =
            facets.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
        const Buffer<std::uint32_t> numbers(plan.device(), some);
        const PlanCopy copy = plan.stay() ? PlanCopy{} : plan.copy(some);
        std::vector<PlanSide> sides =
            sides_of(plan.device(), {plan.stay() ? plan.mesh() : copy.mesh(), numbers.view(), !plan.stay()});
        if (all.empty())
          all = std::move(sides);
        else
          all.insert(all.end(), sides.begin(), sides.end());
      });
  return all;
}

}  // namespace gabarit
