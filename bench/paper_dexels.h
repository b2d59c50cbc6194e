// The paper's schedule of the dexel method, as a baseline: disk by disk and rectangle by rectangle, as many
// at once as do not meet on a line (Inui and Umezu, section 3.1).
#pragma once

#include <span>
#include <vector>

#include "gpu/dexel.h"

namespace gabarit::paper {

// As offset_dexels, line for line the same dexels; `rounds` counts how often all threads had to wait.
Dexels offset_dexels(const Device& device, std::span<const Point2> points, std::span<const PlanEdge> edges,
                     const DexelLines& lines, double radius, std::int64_t& rounds);

}  // namespace gabarit::paper
