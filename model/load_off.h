// OFF (Geomview object file format), the ASCII form in three dimensions.
#pragma once

#include "model/model.h"

namespace gabarit {

// Fills mesh, bodies, format and warnings of `model`; empty when all went well. Colours, normals and texture
// coordinates are passed over. The binary form and four dimensions are refused.
Diagnostics load_off(std::string_view text, const std::string& file, double scale, Model& model);

}  // namespace gabarit
