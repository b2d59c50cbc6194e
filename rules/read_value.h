// Values of parameters from text: of rule files, of descriptors' defaults and of the command line.
#pragma once

#include <span>

#include "rules/quantity.h"

namespace gabarit {

// Points and directions are written "[1 mm, 2 mm, 3 mm]" and "[0, 0, 1]"; a direction also by one of the
// parameter's names, which then is the value.
Result<Value, Complaint> read_value(const Parameter& parameter, const std::string& text);

// Gives every absent parameter its default; the names of those that are required and still absent.
std::vector<std::string> fill_defaults(std::span<const Parameter> parameters, Arguments& arguments);

}  // namespace gabarit
