// A coarse grid over the plan that says where the axis of a column can possibly be when it comes from
// outside, and so which parts of the model it can possibly touch. Always a superset: it only saves time.
#pragma once

#include <cstdint>
#include <vector>

#include "checks/plan_projection.h"

namespace gabarit {

class ReachGrid {
 public:
  // For columns of radius `smallest` to `largest` that touch when nearer than `tolerance`.
  ReachGrid(const PlanProjection& plan, double smallest, double largest, double tolerance);

  // Whether a column that came from outside can possibly come near any side of the polygon.
  bool reached(const PlanPolygon& polygon) const;
  // No axis of such a column can stand nearer to `centre` than this and a quarter of spacing(); negative: it
  // may.
  double axis_gap(Point2 centre) const;
  double spacing() const { return size_; }

 private:
  std::size_t cell(Point2 p) const;
  void mark(const PlanPolygon& polygon, std::vector<std::uint8_t>& cells) const;
  std::vector<std::uint8_t> flood(const std::vector<float>& distance, double free) const;
  std::vector<float> distance_transform(
      const std::vector<std::uint8_t>& cells) const;  // mm between cell centres

  Point2 origin_;
  double size_ = 1;  // of a cell, mm
  std::size_t columns_ = 0, rows_ = 0;
  double reach_ = 0;             // of the second transform
  std::vector<float> distance_;  // from the cells that the axis can be in
};

}  // namespace gabarit
