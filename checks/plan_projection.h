// The facets of a model clipped to a height band and seen from above.
#pragma once

#include <array>
#include <vector>

#include "checks/frame.h"
#include "checks/interval.h"
#include "checks/plan.h"
#include "gpu/device.h"
#include "model/triangle_mesh.h"

namespace gabarit {

// What is left of a facet inside the band, in plan: up to five corners. Side i runs from corner i to the next
// and comes from edge `edge[i]` of the facet, or from the cut (3).
struct PlanPolygon {
  std::array<Point2, 5> corner;
  std::array<std::uint8_t, 5> edge;
  int size = 0;  // 0: nothing is left
};

class PlanProjection {
 public:
  PlanProjection(const TriangleMesh& mesh, const Frame& frame, const Interval& band, const Device& device);

  std::size_t facet_count() const { return mesh_->facet_count(); }
  PlanPolygon polygon(FacetId f) const;  // empty for facets left out
  // Of the parts inside the band; `empty` when nothing is.
  bool empty() const { return !(low_.x <= high_.x); }
  Point2 low() const { return low_; }
  Point2 high() const { return high_; }
  // Facets with a corner that is not finite, or so far off that plane distances lose their meaning.
  std::size_t left_out() const { return left_out_; }

 private:
  const TriangleMesh* mesh_;
  Interval band_;
  std::vector<Vec3d> vertices_;  // vehicle coordinates
  Point2 low_, high_;
  std::size_t left_out_ = 0;
};

}  // namespace gabarit
