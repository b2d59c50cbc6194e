// Which facets a vertical cylinder can touch that stands on the ground and comes from outside (Inui and
// Umezu, Extraction of Vertical Cylinder Contacting Area for Motorcycle Safety Verification).
#pragma once

#include "checks/check.h"

namespace gabarit {

enum class Motion { any, forward, sweep };

// The rolling disk along the facets themselves, or sampled along the lines of a grid as the paper does.
enum class ContactMethod { exact, dexel };

struct VerticalCylinder {
  double radius = 150;  // mm
  Motion motion = Motion::any;
  double tolerance = 0.1;  // touching means nearer than this, mm
  ContactMethod method = ContactMethod::exact;
  double spacing = 0.98;  // of the lines of dexels, mm
};

// The path is found for the radius and for radius ± sag: what is touched at all three is selected, what at
// none is not, the rest is maybe. Dexels add what they may miss between their lines to maybe. Throws
// std::invalid_argument for columns thinner than the sag, and for dexels that are too coarse, too many, or
// asked for a sweep.
Region vertical_cylinder_contact(const Scene& scene, const Setup& setup, const VerticalCylinder& column);

extern const Selector vertical_cylinder_contact_selector;

}  // namespace gabarit
