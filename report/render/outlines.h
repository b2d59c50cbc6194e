// Darkens where the surface ends, folds or jumps in depth, as a draughtsman would ink it.
#pragma once

#include "report/render/tile.h"

namespace gabarit {

// Reads depth, normal and cover of the tile; writes its light. Faint facets get faint lines.
void ink_outlines(Tile& tile);

}  // namespace gabarit
