// What a disk from outside touches, by brute force: a fine raster for the way in, dense samples for the
// contacts.
#pragma once

#include <vector>

#include "checks/outline_features.h"

namespace gabarit::reference {

struct Contacts {
  bool near_tie = false;       // a gap is so near to the diameter that the raster cannot tell
  std::vector<bool> surely;    // touched at a sampled place, to rounding
  std::vector<bool> possibly;  // nearer than the distance between samples
};

// By side. Meant for a handful of sides within some ten radii.
Contacts contacts(const std::vector<PlanSide>& sides, double radius, double tolerance);

}  // namespace gabarit::reference
