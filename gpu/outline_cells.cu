#include "gpu/atomic.h"
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

struct Mark {
  Outlines outlines;
  View<std::uint8_t> cells;

  GABARIT_HD void operator()(std::int64_t i) const {
    outlines.visit(
        i, [](std::int64_t, std::int64_t, double) { return true; },
        [&](std::int64_t cell) {
          store_shared(cells[cell], 1);
          return false;
        });
  }
};

struct Near {
  Outlines outlines;
  View<const float> distance;
  double most;
  View<std::uint8_t> facets;

  GABARIT_HD void operator()(std::int64_t i) const {
    bool near = false;
    const double middles = 2 * outlines.grid.size;  // two points and the middles of their cells
    outlines.visit(
        i,
        [&](std::int64_t a, std::int64_t b, double size) {
          return (static_cast<double>(distance[a]) + distance[b] - size) / 2 - middles <= most;
        },
        [&](std::int64_t cell) { return near = distance[cell] <= most; });
    facets[i] = near ? 1 : 0;
  }
};

constexpr std::int64_t grain = 16384;

}  // namespace

OutlineCells::OutlineCells(const Device& device, const PlanMesh& mesh, const CellGrid& grid)
    : device_(device), grid_(grid), mesh_(mesh) {
  at_ = Buffer<std::int32_t>::of_size(device, mesh.points.size);
  parallel_for(device, mesh.points.size, CellOfPoint{mesh_, grid, at_.view()}, grain);
}

void OutlineCells::mark(std::span<std::uint8_t> cells) const {
  const Outlines outlines{mesh_, grid_, at_.view()};
  if (!device_.has_own_memory())
    return parallel_for(device_, mesh_.facets.size, Mark{outlines, view(cells)}, grain);
  Buffer<std::uint8_t> marked(device_, std::span<const std::uint8_t>(cells));
  parallel_for(device_, mesh_.facets.size, Mark{outlines, marked.view()});
  marked.read(cells);
}

void OutlineCells::near(std::span<const float> distance, double most, std::span<std::uint8_t> facets) const {
  const Outlines outlines{mesh_, grid_, at_.view()};
  if (!device_.has_own_memory())
    return parallel_for(device_, mesh_.facets.size, Near{outlines, view(distance), most, view(facets)},
                        grain);
  const Buffer<float> values(device_, distance);
  auto answers = Buffer<std::uint8_t>::of_size(device_, mesh_.facets.size);
  parallel_for(device_, mesh_.facets.size, Near{outlines, values.view(), most, answers.view()});
  answers.read(facets);
}

}  // namespace gabarit
