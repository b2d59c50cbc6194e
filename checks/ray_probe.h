// Thickness and clearance along rays.
#pragma once

#include "checks/facet_cells.h"

namespace gabarit {

struct RayOptions {
  Side side = Side::inside;
  double cone = 0;          // radians: half angle that the rays fill; 0: one ray along the normal
  int rays = 32;            // in the cone, the one along the normal among them
  bool mean = false;        // of the rays in the cone; else the shortest
  double greatest = 1e300;  // mm: larger distances are not told apart
};

// Distances from the facet to where the rays leave what is measured. Bounds hold while the rays end on the
// same walls.
Probe ray_probe(const ContactSurface& surface, const TriangleMesh& mesh, const RayOptions& options);

}  // namespace gabarit
