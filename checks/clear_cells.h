// Cells that are clear of a limit whatever the normals of the exact surfaces are: these need not be looked at
// closely.
#pragma once

#include "checks/ball_probe.h"

namespace gabarit {

struct ClearOptions {
  double limit = 0;         // mm
  double step = 1;          // mm: cells that are no longer are not looked at
  double normal_error = 0;  // radians: by which normals of surfaces may turn away from their facets'
};

// Sets CellAnswer::clear. A facet counts or not by its normal; the surface behind it, and the surface at the
// cell, may lie on the other side of the separation angle: the cells are asked again with a smaller one.
Probe with_clear_cells(Probe probe, const ContactSurface& surface, const BallOptions& balls,
                       const ClearOptions& options);

}  // namespace gabarit
