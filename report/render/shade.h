// Gives every sample of a tile the light of its facet.
#pragma once

#include "report/render/raster.h"

namespace gabarit {

// Fills light, normal and cover from the facets in front. A key light from the upper left, a weaker one from
// the right, more from above than from below, and a slight sheen; both sides of a facet are lit alike.
void shade(const Facets& facets, Tile& tile);

}  // namespace gabarit
