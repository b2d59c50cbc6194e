// Lines through the ends of dexels, for pictures.
#pragma once

#include <vector>

#include "checks/disk_path.h"
#include "gpu/dexel.h"

namespace gabarit {

// `on_rows` lie on lines of `rows`, `on_columns` on lines of `columns` (x and y exchanged). Within a square
// of the grid two ends are joined; of more, neighbours around the square, in the shorter of the two ways.
std::vector<Contour> dexel_contours(const std::vector<Point2>& on_rows, const std::vector<Point2>& on_columns,
                                    const DexelLines& rows, const DexelLines& columns);

}  // namespace gabarit
