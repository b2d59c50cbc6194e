// Which cells of a grid are connected to its corner.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/cell_grid.h"

namespace gabarit {

// By cell: 1 when a way through cells whose value is at least `free` leads there from cell 0, through
// corners, too. Cell 0 itself is free.
std::vector<std::uint8_t> flood(const CellGrid& grid, const std::vector<float>& value, double free);

}  // namespace gabarit
