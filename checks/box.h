// Selects what reaches into a box in the model's coordinates.
#pragma once

#include <span>

#include "checks/check.h"

namespace gabarit {

extern const Selector box_selector;

// Whether a triangle (three corners) or a segment (two) and the closed box have a point in common; separating
// axes (Akenine-Möller 2001, "Fast 3D triangle-box overlap testing"), with slack for rounding: it may say yes
// to what misses the box by 1e-12 of the coordinates, never no to what meets it. Finite corners.
bool meets(const Box3d& box, std::span<const Vec3d> corners);

}  // namespace gabarit
