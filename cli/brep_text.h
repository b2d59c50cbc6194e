// The exact surfaces of a model in words, for `gabarit info`.
#pragma once

#include <string>

#include "model/model.h"

namespace gabarit {

// Lines of the same form as the rest of `gabarit info`; empty without a B-Rep.
std::string brep_text(const Model& model);

}  // namespace gabarit
