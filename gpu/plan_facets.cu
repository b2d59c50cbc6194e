#include "gpu/parallel_for.h"
#include "gpu/plan_facets.h"

namespace gabarit {
namespace {

struct Turn {
  View<const Vec3d> from;
  View<Vec3d> to;  // may be the same memory
  PlanAxes axes;

  GABARIT_HD void operator()(std::int64_t i) const { to[i] = axes(from[i]); }
};

// Index i looks at facets i * ahead, i * ahead + step, … `count` of them: a core at neighbours, the threads
// of a GPU side by side.
struct FindExtents {
  PlanMesh mesh;
  View<PlanExtent> extents;
  std::int64_t ahead, step, count;

  GABARIT_HD void operator()(std::int64_t i) const {
    PlanExtent extent;
    const std::int64_t first = i * ahead, all = mesh.facets.size;
    const std::int64_t end = first + count * step < all ? first + count * step : all;
    for (std::int64_t facet = first; facet < end; facet += step) add(facet, extent);
    extents[i] = extent;
  }

 private:
  GABARIT_HD void add(std::int64_t facet, PlanExtent& extent) const {
    const std::array<std::uint32_t, 3>& f = mesh.facets[facet];
    const Vec3d& a = mesh.points[f[0]];
    const Vec3d& b = mesh.points[f[1]];
    const Vec3d& c = mesh.points[f[2]];
    if (mesh.holds(a) && mesh.holds(b) && mesh.holds(c)) {
      extent.add(Point2{a.x, a.y});
      extent.add(Point2{b.x, b.y});
      extent.add(Point2{c.x, c.y});
      return;
    }
    const PlanPolygon part = mesh.polygon(facet);
    for (int n = 0; n < part.size; ++n) extent.add(part.corner[n]);
    if (!measurable(a) || !measurable(b) || !measurable(c)) ++extent.left_out;
  }
};

PlanExtent extent_of(const Device& device, const PlanMesh& mesh) {
  const std::int64_t facets = mesh.facets.size;
  const std::int64_t count = device.has_own_memory() ? 64 : 32768;
  const std::int64_t indices = (facets + count - 1) / count;
  auto extents = Buffer<PlanExtent>::of_size(device, indices);
  const FindExtents kernel = device.has_own_memory() ? FindExtents{mesh, extents.view(), 1, indices, count}
                                                     : FindExtents{mesh, extents.view(), count, 1, count};
  parallel_for(device, indices, kernel, 1);
  PlanExtent all;
  for (const PlanExtent& extent : extents.read()) {
    all.left_out += extent.left_out;
    if (extent.empty()) continue;
    all.add(extent.low);
    all.add(extent.high);
  }
  return all;
}

}  // namespace

PlanFacets::PlanFacets(const Device& device, std::span<const Vec3d> points,
                       std::span<const std::array<std::uint32_t, 3>> facets, const PlanAxes& axes,
                       double from, double to)
    : device_(device), facets_here_(facets), from_(from), to_(to) {
  constexpr std::int64_t grain = 65536;
  const auto n = static_cast<std::int64_t>(points.size());
  if (device.has_own_memory()) {
    facets_ = Buffer<std::array<std::uint32_t, 3>>(device, facets);
    points_ = Buffer<Vec3d>(device, points);
    parallel_for(device, n, Turn{std::as_const(points_).view(), points_.view(), axes});
  } else {
    points_ = Buffer<Vec3d>::of_size(device, n);
    parallel_for(device, n, Turn{gabarit::view(points), points_.view(), axes}, grain);
  }
  extent_ = extent_of(device, mesh());
}

PlanMesh PlanFacets::mesh() const {
  return {points_.view(), device_.has_own_memory() ? facets_.view() : view(facets_here_), from_, to_};
}

}  // namespace gabarit
