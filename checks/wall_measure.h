// What thickness and clearance have in common: parameters, and the measurement on either side of the surface.
#pragma once

#include "checks/check.h"
#include "checks/contact_surface.h"

namespace gabarit {

std::vector<Parameter> wall_parameters(Side side);

// Throws std::invalid_argument when parameters are given that the method does not use.
Field measure_walls(Side side, const Scene& scene, const Setup& setup, const Region& region,
                    const Arguments& arguments);

// "the largest ball between opposite walls, which turn away by 120 deg": the method for a report.
std::string method_text(const Arguments& arguments);

}  // namespace gabarit
