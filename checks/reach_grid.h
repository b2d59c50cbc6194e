// A coarse grid over the plan that says where the axis of a column can possibly be when it comes from
// outside, and so which parts of the model it can possibly touch. Always a superset: it only saves time.
#pragma once

#include <cstdint>
#include <vector>

#include "checks/plan_projection.h"
#include "gpu/cell_grid.h"
#include "gpu/outline_cells.h"

namespace gabarit {

class ReachGrid {
 public:
  // For columns of radius `smallest` to `largest` that touch when nearer than `tolerance`. `plan` must
  // outlive this.
  ReachGrid(const PlanProjection& plan, double smallest, double largest, double tolerance,
            const Device& device);

  // By facet: 0 when no column that came from outside can come near any of its sides.
  const std::vector<std::uint8_t>& reached() const { return reached_; }
  // No axis of such a column can stand nearer to `centre` than this and a quarter of spacing(); negative: it
  // may.
  double axis_gap(Point2 centre) const;
  double spacing() const { return grid_.size; }

  const CellGrid& grid() const { return grid_; }
  // By cell: from its centre to that of the nearest cell with a point of an outline, mm.
  const std::vector<float>& outline_distance() const { return outline_distance_; }
  const OutlineCells& outlines() const { return outlines_; }

 private:
  CellGrid grid_;
  OutlineCells outlines_;
  std::vector<float> outline_distance_;
  std::vector<float> distance_;  // from the cells that the axis can be in, mm between centres
  std::vector<std::uint8_t> reached_;
};

}  // namespace gabarit
