// Where a disk that touches one feature of an outline overlaps others: the free parts of each feature's
// offset curve.
#pragma once

#include <cstdint>
#include <vector>

#include "checks/disk_path.h"
#include "checks/free_intervals.h"
#include "gpu/segment_grid.h"

namespace gabarit {

// The features of an outline in a grid: points first, then edges.
class FeatureGrid {
 public:
  FeatureGrid(const OutlineFeatures& outline, double radius, const ReachGrid* reach);

  const OutlineFeatures& outline() const { return *outline_; }
  const SegmentGrid& squares() const { return squares_; }
  double radius() const { return radius_; }
  const ReachGrid* reach() const { return reach_; }  // may be null

 private:
  const OutlineFeatures* outline_;
  double radius_;
  const ReachGrid* reach_;
  SegmentGrid squares_;
};

// The free pieces of the circle around a point, and of the two lines beside an edge, in the order of their
// parameter.
void free_arcs(const FeatureGrid& grid, std::uint32_t point, std::vector<PathPiece>& out);
void free_lines(const FeatureGrid& grid, std::uint32_t edge, std::vector<PathPiece>& out);

}  // namespace gabarit
