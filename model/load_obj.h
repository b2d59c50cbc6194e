// Wavefront OBJ (Wavefront Technologies, Advanced Visualizer Manual, appendix B1, 1992): polygons and names.
#pragma once

#include "model/model.h"

namespace gabarit {

// Fills mesh, bodies, format and warnings of `model`; empty when all went well. Bodies are the objects and
// groups that have faces. Materials and texture files are never opened. Free-form surfaces, lines that begin
// with an unknown word and faces of fewer than three corners are left out with a warning.
Diagnostics load_obj(std::string_view text, const std::string& file, double scale, Model& model);

}  // namespace gabarit
