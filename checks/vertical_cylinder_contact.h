// Which facets a vertical cylinder can touch that stands on the ground and comes from outside (Inui and
// Umezu, Extraction of Vertical Cylinder Contacting Area for Motorcycle Safety Verification).
#pragma once

#include "checks/check.h"

namespace gabarit {

enum class Motion { any, forward, sweep };

struct VerticalCylinder {
  double radius = 150;  // mm
  Motion motion = Motion::any;
  double tolerance = 0.1;  // touching means nearer than this, mm
};

// The path is found for the radius and for radius ± sag: what is touched at all three is selected, what at
// none is not, the rest is maybe.
Region vertical_cylinder_contact(const Scene& scene, const Setup& setup, const VerticalCylinder& column);

extern const Selector vertical_cylinder_contact_selector;

}  // namespace gabarit
