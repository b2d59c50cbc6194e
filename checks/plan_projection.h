// The facets of a model clipped to a height band and seen from above.
#pragma once

#include <vector>

#include "checks/frame.h"
#include "checks/interval.h"
#include "gpu/device.h"
#include "gpu/plan_mesh.h"
#include "model/triangle_mesh.h"

namespace gabarit {

class PlanProjection {
 public:
  PlanProjection(const TriangleMesh& mesh, const Frame& frame, const Interval& band, const Device& device);

  std::size_t facet_count() const { return mesh_->facet_count(); }
  PlanPolygon polygon(FacetId f) const { return mesh().polygon(f); }  // empty for facets left out
  // Views of this and of the mesh it was made of.
  PlanMesh mesh() const;
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
