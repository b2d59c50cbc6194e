// Whether a ray that starts on a surface ends on the back of a wall, as it does in every closed part.
#pragma once

#include <vector>

#include "checks/facet_cells.h"

namespace gabarit {

enum class Exit {
  right,  // it meets a facet that faces away
  none,   // it meets nothing
  wrong,  // it meets a facet that faces it: it left by a gap, or that facet is flipped, or its own is
};

std::vector<Exit> exits_of(const ContactSurface& surface, std::span<const CellQuery> queries, double from);

}  // namespace gabarit
