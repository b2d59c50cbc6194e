// Small mesh files in every format, written by hand, and what loading them gives.
#pragma once

#include <string>

#include "model/load.h"
#include "model/ply_header.h"
#include "tests/shapes.h"

namespace gabarit::mesh_files {

std::string binary_stl(const shapes::Triangles& triangles);
std::string ascii_stl(const shapes::Triangles& triangles, const std::string& line_end = "\n",
                      const std::string& name = "part");
std::string obj(const shapes::Triangles& triangles);
std::string ply(const shapes::Triangles& triangles, PlyFormat format = PlyFormat::ascii);
std::string off(const shapes::Triangles& triangles);

// The file lives in a temporary folder while it is read.
Result<Model> load_bytes(const std::string& file_name, const std::string& bytes,
                         const LoadOptions& options = {});
// All diagnostics as the user sees them: the errors, or the warnings of a model.
std::string said(const Result<Model>& result);
// The corners of every facet, in order.
shapes::Triangles corners(const Model& model);

}  // namespace gabarit::mesh_files
