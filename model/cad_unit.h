// The unit that a CAD file declares, in its own words.
#pragma once

#include <span>
#include <string>

#include "model/load.h"

namespace gabarit {

// `names` are the length units of the file, such as "millimetre", "INCH" or "MM"; the first that is known is
// the model's. Says so when the user gave another, when the file has several, or when none is known.
void set_declared_unit(std::span<const std::string> names, const std::string& file,
                       const LoadOptions& options, Model& model);

}  // namespace gabarit
