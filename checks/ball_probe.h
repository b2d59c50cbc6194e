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

// Diameters. A ball that nothing stops is infinite outside, and inside a closed mesh, where no wall lies
// opposite; where a gap or a facet of the wrong orientation lets it through it is `open`, and so is every
// ball without end that is asked for as the greatest.
Probe ball_probe(const ContactSurface& surface, const BallOptions& options);

}  // namespace gabarit
