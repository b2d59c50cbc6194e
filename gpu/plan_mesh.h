// Triangles as views of kernels, and what a height band leaves of each in plan.
#pragma once

#include <array>

#include "gpu/plan_polygon.h"
#include "gpu/view.h"

namespace gabarit {

struct PlanMesh {
  View<const Vec3d> points;  // x rearward, y to the right, z up
  View<const std::array<std::uint32_t, 3>> facets;
  double from = 0, to = 0;  // heights; may be infinite

  // The band leaves the point whole, and it is measurable.
  GABARIT_HD bool holds(const Vec3d& p) const { return measurable(p) && from <= p.z && p.z <= to; }
  GABARIT_HD PlanPolygon polygon(std::int64_t facet) const {
    const std::array<std::uint32_t, 3>& f = facets[facet];
    return plan_polygon(points[f[0]], points[f[1]], points[f[2]], from, to);
  }
};

}  // namespace gabarit
