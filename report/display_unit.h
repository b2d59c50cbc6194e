// The unit in which a quantity is shown to people and machines, and the factor from the inside unit.
#pragma once

#include "checks/arguments.h"

namespace gabarit {

struct DisplayUnit {
  const char* name = "";  // empty for plain numbers
  double factor = 1;      // shown = inside * factor
};

// Lengths in mm, areas in mm², angles in degrees.
constexpr DisplayUnit display_unit(Dimension dimension) {
  switch (dimension) {
    case Dimension::length:
    case Dimension::point: return {"mm", 1};
    case Dimension::area: return {"mm2", 1};
    case Dimension::angle: return {"deg", 57.29577951308232};
    default: return {};
  }
}

}  // namespace gabarit
