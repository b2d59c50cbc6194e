// OBJ, PLY and OFF through OpenMesh's importer interface, into a plain facet list.
#pragma once

#include "model/load.h"
#include "model/mapped_file.h"

namespace gabarit {

// Fills mesh, bodies and warnings of `model`; empty when all went well. `ending` is ".obj", ".ply" or ".off".
// Polygons are cut into triangles by ear clipping. Weak spot: OpenMesh's readers keep coordinates in single
// precision.
Diagnostics load_openmesh(const std::filesystem::path& file, std::string_view bytes,
                          const std::string& ending, double scale, Model& model);

}  // namespace gabarit
