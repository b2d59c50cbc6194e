#include <algorithm>
#include <utility>

#include "gpu/atomic.h"
#include "gpu/batches.h"
#include "gpu/outline_cells.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

struct CellOfPoint {
  PlanMesh mesh;
  CellGrid grid;
  View<std::int32_t> at;

  GABARIT_HD void operator()(std::int64_t i) const {
    const Vec3d p = mesh.points[i];
    at[i] = mesh.holds(p) ? static_cast<std::int32_t>(grid.cell({p.x, p.y})) : -1;
  }
};

struct Outlines {
  PlanMesh mesh;
  CellGrid grid;
  View<const std::int32_t> at;

  // Calls use(cell) for corners and points between them until it returns true. between(cell, cell, length)
  // says whether it wants those between two corners.
  template <class Between, class Use>
  GABARIT_HD void visit(std::int64_t facet, Between&& between, Use&& use) const {
    const std::array<std::uint32_t, 3>& f = mesh.facets[facet];
    const std::int32_t cell[3] = {at[f[0]], at[f[1]], at[f[2]]};
    if (cell[0] < 0 || cell[1] < 0 || cell[2] < 0) return visit_clipped(mesh.polygon(facet), use);
    if (use(cell[0]) || use(cell[1]) || use(cell[2])) return;
    for (int i = 0; i < 3; ++i) {
      const int j = i < 2 ? i + 1 : 0;
      if (beside(cell[i], cell[j])) continue;
      const Vec3d& a = mesh.points[f[static_cast<std::size_t>(i)]];
      const Vec3d& b = mesh.points[f[static_cast<std::size_t>(j)]];
      const double size = length(Point2{b.x - a.x, b.y - a.y});
      if (!between(cell[i], cell[j], size)) continue;
      if (visit_between({a.x, a.y}, {b.x, b.y}, size, use)) return;
    }
  }

 private:
  template <class Use>
  GABARIT_HD void visit_clipped(const PlanPolygon& polygon, Use& use) const {
    for (int i = 0; i < polygon.size; ++i) {
      const Point2 a = polygon.corner[i];
      const Point2 b = polygon.next(i);
      if (use(grid.cell(a)) || visit_between(a, b, length(b - a), use)) return;
    }
  }
  // A segment between two such cells lies in them.
  GABARIT_HD bool beside(std::int32_t a, std::int32_t b) const {
    const std::int64_t apart = a < b ? b - a : a - b;
    return apart <= 1 || apart == grid.columns;
  }
  template <class Use>
  GABARIT_HD bool visit_between(Point2 a, Point2 b, double size, Use& use) const {
    if (size <= grid.size) return false;
    const int steps = static_cast<int>(std::ceil(size / grid.size));
    const Point2 from = (a - grid.origin) * (1 / grid.size);
    const Point2 step = (b - a) * (1 / (grid.size * steps));
    for (int k = 1; k < steps; ++k) {
      const auto x = static_cast<std::int64_t>(from.x + k * step.x);
      const auto y = static_cast<std::int64_t>(from.y + k * step.y);
      if (use(y * grid.columns + x)) return true;
    }
    return false;
  }
};

// The cells from number `first` on of which there are values.
template <class T>
struct CellBand {
  View<T> values;
  std::int64_t first;

  GABARIT_HD bool holds(std::int64_t cell) const { return cell >= first && cell - first < values.size; }
  GABARIT_HD T& operator[](std::int64_t cell) const { return values[cell - first]; }
};

struct Mark {
  Outlines outlines;
  CellBand<std::uint8_t> cells;

  GABARIT_HD void operator()(std::int64_t i) const {
    outlines.visit(
        i, [](std::int64_t, std::int64_t, double) { return true; },
        [&](std::int64_t cell) {
          if (cells.holds(cell)) store_shared(cells[cell], 1);
          return false;
        });
  }
};

struct Near {
  Outlines outlines;
  CellBand<const float> distance;
  double most;
  View<std::uint8_t> facets;

  GABARIT_HD void operator()(std::int64_t i) const {
    bool near = false;
    const double middles = 2 * outlines.grid.size;  // two points and the middles of their cells
    outlines.visit(
        i,
        [&](std::int64_t a, std::int64_t b, double size) {
          if (!distance.holds(a) || !distance.holds(b)) return true;
          return (static_cast<double>(distance[a]) + distance[b] - size) / 2 - middles <= most;
        },
        [&](std::int64_t cell) { return near = distance.holds(cell) && distance[cell] <= most; });
    facets[i] = near ? 1 : 0;
  }
};

constexpr std::int64_t grain = 16384;

Buffer<std::int32_t> cells_of_points(const Device& device, const PlanMesh& mesh, const CellGrid& grid) {
  auto at = Buffer<std::int32_t>::of_size(device, mesh.points.size);
  parallel_for(device, mesh.points.size, CellOfPoint{mesh, grid, at.view()}, grain);
  return at;
}

PlanMesh some_of(PlanMesh mesh, std::int64_t begin, std::int64_t end) {
  mesh.facets = {mesh.facets.data + begin, end - begin};
  return mesh;
}

// Calls work(cells, number of the first) for bands of whole rows.
template <class T, class Work>
void in_bands(const CellGrid& grid, std::span<T> cells, Work&& work) {
  in_batches(grid.rows, 1, [&](std::int64_t begin, std::int64_t end) {
    const std::int64_t first = begin * grid.columns, count = (end - begin) * grid.columns;
    work(cells.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count)), first);
  });
}

}  // namespace

OutlineCells::OutlineCells(const PlanFacets& plan, const CellGrid& grid)
    : plan_(&plan), grid_(grid), stay_(plan.stay() && take_there()) {}

bool OutlineCells::take_there() {
  try {
    at_ = cells_of_points(plan_->device(), plan_->mesh(), grid_);
    return true;
  } catch (const OutOfDeviceMemory&) {
    return false;
  }
}

// Calls work(outlines, number of the first facet) for facets in a row.
template <class Work>
void OutlineCells::in_parts(Work&& work) const {
  in_batches(plan_->size(), facets_of_a_copy, [&](std::int64_t begin, std::int64_t end) {
    if (stay_) return work(Outlines{some_of(plan_->mesh(), begin, end), grid_, at_.view()}, begin);
    const PlanCopy copy = plan_->copy(begin, end);
    const Buffer<std::int32_t> at = cells_of_points(plan_->device(), copy.mesh(), grid_);
    work(Outlines{copy.mesh(), grid_, at.view()}, begin);
  });
}

void OutlineCells::mark(std::span<std::uint8_t> cells) const {
  const Device& device = plan_->device();
  in_bands(grid_, cells, [&](std::span<std::uint8_t> band, std::int64_t first) {
    Buffer<std::uint8_t> there;
    if (device.has_own_memory()) there = {device, std::span<const std::uint8_t>(band)};
    const CellBand<std::uint8_t> marked{device.has_own_memory() ? there.view() : view(band), first};
    in_parts([&](const Outlines& outlines, std::int64_t) {
      parallel_for(device, outlines.mesh.facets.size, Mark{outlines, marked}, grain);
    });
    if (device.has_own_memory()) there.read(band);
  });
}

void OutlineCells::near(std::span<const float> distance, double most, std::span<std::uint8_t> facets) const {
  const Device& device = plan_->device();
  std::fill(facets.begin(), facets.end(), std::uint8_t{0});
  in_bands(grid_, distance, [&](std::span<const float> band, std::int64_t first) {
    Buffer<float> there;
    if (device.has_own_memory()) there = {device, band};
    const CellBand<const float> values{device.has_own_memory() ? std::as_const(there).view() : view(band),
                                       first};
    in_parts([&](const Outlines& outlines, std::int64_t begin) {
      auto answers = Buffer<std::uint8_t>::of_size(device, outlines.mesh.facets.size);
      parallel_for(device, answers.size(), Near{outlines, values, most, answers.view()}, grain);
      for (const std::uint8_t near : std::move(answers).read())
        facets[static_cast<std::size_t>(begin++)] |= near;
    });
  });
}

}  // namespace gabarit
