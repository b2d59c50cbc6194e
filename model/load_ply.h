// PLY, the polygon file format (Turk, 1994): ASCII and binary, both byte orders.
#pragma once

#include "model/model.h"

namespace gabarit {

// Fills mesh, bodies, format and warnings of `model`; empty when all went well. Elements other than "vertex"
// and "face" are passed over, but for those that hold faces in another form, such as triangle strips: errors.
Diagnostics load_ply(std::string_view bytes, const std::string& file, double scale, Model& model);

}  // namespace gabarit
