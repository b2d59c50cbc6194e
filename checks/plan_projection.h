// The facets of a model clipped to a height band and seen from above.
#pragma once

#include "checks/frame.h"
#include "checks/interval.h"
#include "gpu/plan_facets.h"
#include "model/triangle_mesh.h"

namespace gabarit {

class PlanProjection {
 public:
  // The mesh must outlive this. Throws DeviceError and OutOfDeviceMemory.
  PlanProjection(const TriangleMesh& mesh, const Frame& frame, const Interval& band, const Device& device)
      : facets_(device, mesh.vertices, mesh.facets, frame.plan_axes(), band.from, band.to),
        facet_count_(mesh.facet_count()) {}

  std::size_t facet_count() const { return facet_count_; }
  const Device& device() const { return facets_.device(); }
  const PlanFacets& facets() const { return facets_; }
  // Of the parts inside the band; `empty` when nothing is.
  bool empty() const { return facets_.extent().empty(); }
  Point2 low() const { return facets_.extent().low; }
  Point2 high() const { return facets_.extent().high; }
  // Facets with a corner that is not finite, or so far off that plane distances lose their meaning.
  std::size_t left_out() const { return static_cast<std::size_t>(facets_.extent().left_out); }

 private:
  PlanFacets facets_;
  std::size_t facet_count_;
};

}  // namespace gabarit
