#include "gpu/batches.h"
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

void add(PlanExtent& all, const PlanExtent& extent) {
  all.left_out += extent.left_out;
  if (extent.empty()) return;
  all.add(extent.low);
  all.add(extent.high);
}

PlanExtent extent_of(const Device& device, const PlanMesh& mesh) {
  const std::int64_t facets = mesh.facets.size;
  const std::int64_t count = device.has_own_memory() ? 64 : 32768;
  const std::int64_t indices = (facets + count - 1) / count;
  auto extents = Buffer<PlanExtent>::of_size(device, indices);
  const FindExtents kernel = device.has_own_memory() ? FindExtents{mesh, extents.view(), 1, indices, count}
                                                     : FindExtents{mesh, extents.view(), count, 1, count};
  parallel_for(device, indices, kernel, 1);
  PlanExtent all;
  for (const PlanExtent& extent : extents.read()) add(all, extent);
  return all;
}

}  // namespace

PlanFacets::PlanFacets(const Device& device, std::span<const Vec3d> points, std::span<const Corners> facets,
                       const PlanAxes& axes, double from, double to)
    : device_(device), points_here_(points), facets_here_(facets), axes_(axes), from_(from), to_(to) {
  constexpr std::int64_t grain = 65536;
  if (device.has_own_memory()) {
    stay_ = take_there();
  } else {
    const auto n = static_cast<std::int64_t>(points.size());
    points_ = Buffer<Vec3d>::of_size(device, n);
    parallel_for(device, n, Turn{gabarit::view(points), points_.view(), axes}, grain);
  }
  extent_ = find_extent();
}

// As much again has to be free: what looks at the facets needs room too.
bool PlanFacets::take_there() {
  try {
    facets_ = Buffer<Corners>(device_, facets_here_);
    points_ = Buffer<Vec3d>(device_, points_here_);
    const DeviceMemory room(device_, facets_.bytes() + points_.bytes());
    parallel_for(device_, points_.size(), Turn{std::as_const(points_).view(), points_.view(), axes_});
    return true;
  } catch (const OutOfDeviceMemory&) {
    facets_ = {};
    points_ = {};
    return false;
  }
}

PlanMesh PlanFacets::mesh() const {
  return {points_.view(), device_.has_own_memory() ? facets_.view() : view(facets_here_), from_, to_};
}

template <class FacetAt>
PlanCopy PlanFacets::copy_of(std::int64_t n, FacetAt&& facet_at) const {
  std::vector<Vec3d> points;
  std::vector<Corners> facets;
  points.reserve(static_cast<std::size_t>(3 * n));
  facets.reserve(static_cast<std::size_t>(n));
  for (std::int64_t i = 0; i < n; ++i) {
    const auto first = static_cast<std::uint32_t>(points.size());
    facets.push_back({first, first + 1, first + 2});
    for (const std::uint32_t p : facets_here_[facet_at(i)]) points.push_back(points_here_[p]);
  }
  PlanCopy copy{{device_, std::move(points)}, {device_, std::move(facets)}, from_, to_};
  parallel_for(device_, copy.points.size(),
               Turn{std::as_const(copy.points).view(), copy.points.view(), axes_});
  return copy;
}

PlanCopy PlanFacets::copy(std::int64_t begin, std::int64_t end) const {
  return copy_of(end - begin, [&](std::int64_t i) { return static_cast<std::size_t>(begin + i); });
}

PlanCopy PlanFacets::copy(std::span<const std::uint32_t> chosen) const {
  return copy_of(static_cast<std::int64_t>(chosen.size()),
                 [&](std::int64_t i) { return std::size_t{chosen[static_cast<std::size_t>(i)]}; });
}

PlanExtent PlanFacets::find_extent() const {
  if (stay_) return extent_of(device_, mesh());
  PlanExtent all;
  in_batches(size(), facets_of_a_copy, [&](std::int64_t begin, std::int64_t end) {
    add(all, extent_of(device_, copy(begin, end).mesh()));
  });
  return all;
}

}  // namespace gabarit
