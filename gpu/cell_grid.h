// Square cells over the plan.
#pragma once

#include <cstdint>

#include "gpu/point2.h"

namespace gabarit {

struct CellGrid {
  Point2 origin;
  double size = 1;  // of a cell, mm
  std::int64_t columns = 0, rows = 0;

  GABARIT_HD std::int64_t count() const { return columns * rows; }
  // Row by row. The point must lie in the grid.
  GABARIT_HD std::int64_t cell(Point2 p) const {
    const auto x = static_cast<std::int64_t>((p.x - origin.x) / size);
    const auto y = static_cast<std::int64_t>((p.y - origin.y) / size);
    return y * columns + x;
  }
};

}  // namespace gabarit
