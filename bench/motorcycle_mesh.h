// The example motorcycle, tessellated to any size.
#pragma once

#include <cstddef>

#include "model/model.h"

namespace gabarit {

// About `facets` facets (within a few per cent) at a sag of 0.1 mm, as loaded from its STL.
Model motorcycle_mesh(std::size_t facets);

}  // namespace gabarit
