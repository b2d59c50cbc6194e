// Thickness and clearance by the largest ball: the sphere method and its variant for walls.
#pragma once

#include "checks/facet_cells.h"

namespace gabarit {

struct BallOptions {
  Side side = Side::inside;
  double separation = 2.0943951023931953;  // radians: a contact's normal turns away at least so far
  double greatest = 1e300;                 // mm: larger diameters are not looked for
  Extreme extreme = Extreme::smallest;
};

// Diameters. Inside, a ball that nothing stops, or that a gap or a facet of the wrong orientation lets
// through, is `open`; outside it is infinite.
Probe ball_probe(const ContactSurface& surface, const BallOptions& options);

}  // namespace gabarit
