// A second opinion on the path of a column, from the grid alone: what the column surely reaches must lie
// beside the path. The path rests on a chain of joins; this rests on a flood with a margin for the squares'
// size.
#pragma once

#include <cstdint>
#include <vector>

#include "checks/disk_path.h"
#include "checks/reach_grid.h"

namespace gabarit {

// By facet: 1 when a column of the path's radius surely comes near it at a place that the path knows nothing
// of. All 0 when the path is whole, down to pieces of a few squares; empty when there is no such place at
// all. `gap`: the path is known at places that are no further apart than this.
std::vector<std::uint8_t> missed_by(const DiskPath& path, const ReachGrid& reach, double gap,
                                    const Device& device);

}  // namespace gabarit
