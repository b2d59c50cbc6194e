// How far each cell of a grid is from the nearest marked one.
#pragma once

#include <cstdint>
#include <span>

#include "gpu/cell_grid.h"
#include "gpu/device.h"

namespace gabarit {

// Between the centres of cells, mm; infinite when nothing is marked. Squares of distances are exact integers
// (in cells) before the root is taken, whatever the order of the work. Two passes, along columns and along
// rows: Felzenszwalb and Huttenlocher, Distance Transforms of Sampled Functions, 2012. Grids that do not fit
// into the memory of the device go in strips and bands. Throws DeviceError, and OutOfDeviceMemory when not
// even one column and one row fit.
void distance_transform(const Device& device, const CellGrid& grid, std::span<const std::uint8_t> marked,
                        std::span<float> distance);

}  // namespace gabarit
