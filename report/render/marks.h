// Keeps marked facets visible that are too small to cover samples of their own.
#pragma once

#include "report/render/raster.h"

namespace gabarit {

// Where a marked facet that is thin on the page is not hidden, and less than two pixels' worth of equally
// marked surface shows around, a dot of 2.5 pixels in its plain colour. A facet is taken as hidden only where
// everything within a sample of it is nearer. Call after shading: reads depth, writes light and cover.
void stamp_marks(const Facets& facets, std::span<const FacetId> listed, std::span<const FacetId> large,
                 Tile& tile);

}  // namespace gabarit
