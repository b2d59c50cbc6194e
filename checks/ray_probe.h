// Thickness and clearance along rays.
#pragma once

#include "checks/facet_cells.h"

namespace gabarit {

constexpr double ray_floor_share = 1e-6;  // of the model's size: hits nearer than that do not count

struct RayOptions {
  Side side = Side::inside;
  double cone = 0;          // radians: half angle that the rays fill; 0: one ray along the normal
  int rays = 32;            // in the cone, the one along the normal among them
  bool mean = false;        // of the rays in the cone; else the shortest
  double greatest = 1e300;  // mm: larger distances are not told apart
};

// How many rays a query sends.
int ray_count(const RayOptions& options);
// The direction of ray `number` about an axis, spread evenly over the cap; `sideways` is a unit vector across
// the axis. 0: the axis.
Vec3d ray_direction(const RayOptions& options, const Vec3d& axis, const Vec3d& sideways, int number);
// A unit vector across `axis` that turns with the facet: along its longest edge.
Vec3d sideways(const TriangleMesh& mesh, FacetId facet, const Vec3d& axis);

// Distances from the facet to where the rays leave what is measured. Bounds hold while the rays end on the
// same walls.
Probe ray_probe(const ContactSurface& surface, const TriangleMesh& mesh, const RayOptions& options);

}  // namespace gabarit
