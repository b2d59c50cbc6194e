#include "checks/reach_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "checks/flood.h"
#include "gpu/distance_transform.h"

namespace gabarit {

static constexpr double diagonal = std::numbers::sqrt2;
static constexpr double most_cells = 16e6;

// Room for a column of the largest radius to go around everything.
static CellGrid grid_around(const PlanProjection& plan, double smallest, double largest) {
  const Point2 extent = plan.high() - plan.low();
  const double margin = 2 * largest;
  const double area = (extent.x + 2 * margin) * (extent.y + 2 * margin);
  CellGrid grid;
  grid.size = std::max(smallest / 75, std::sqrt(area / most_cells));
  const double border = margin + 4 * grid.size;
  grid.origin = plan.low() - Point2{border, border};
  grid.columns = static_cast<std::int64_t>(std::ceil((extent.x + 2 * border) / grid.size)) + 1;
  grid.rows = static_cast<std::int64_t>(std::ceil((extent.y + 2 * border) / grid.size)) + 1;
  return grid;
}

ReachGrid::ReachGrid(const PlanProjection& plan, double smallest, double largest, double tolerance,
                     const Device& device)
    : grid_(grid_around(plan, smallest, largest)),
      outlines_(plan.facets(), grid_),
      outline_distance_(static_cast<std::size_t>(grid_.count())),
      distance_(outline_distance_.size()),
      reached_(plan.facet_count()) {
  std::vector<std::uint8_t> cells(distance_.size(), 0);
  outlines_.mark(cells);
  distance_transform(device, grid_, cells, outline_distance_);
  // A place is free only if its distance is at least the radius; cell centres are off by a diagonal in all.
  // A hundredth of a cell more covers the rounding of single precision.
  cells = flood(grid_, outline_distance_, smallest - (diagonal + 0.01) * grid_.size);
  distance_transform(device, grid_, cells, distance_);
  outlines_.near(distance_, largest + tolerance + (diagonal + 0.51) * grid_.size, reached_);
}

// Places a quarter of a square apart lie in the same square or in neighbours, whose middles are at most a
// diagonal apart.
double ReachGrid::axis_gap(Point2 centre) const {
  const Point2 at = (centre - grid_.origin) * (1 / grid_.size);
  const bool inside = at.x >= 0 && at.y >= 0 && at.x < static_cast<double>(grid_.columns) &&
                      at.y < static_cast<double>(grid_.rows);
  return inside ? distance_[static_cast<std::size_t>(grid_.cell(centre))] - 1.5 * grid_.size : -1;
}

}  // namespace gabarit
