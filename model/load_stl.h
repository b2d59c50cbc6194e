// STL, binary and ASCII (3D Systems, StereoLithography Interface Specification, 1988).
#pragma once

#include "model/load.h"
#include "model/mapped_file.h"

namespace gabarit {

enum class StlKind { binary, ascii, neither };
// Many binary files begin with "solid" and some ASCII files with a comment: the size decides first, then the
// words.
StlKind stl_kind(std::string_view bytes);

// Fill mesh, bodies, format and warnings of `model`; empty when all went well. Coordinates are multiplied by
// `scale`.
Diagnostics load_binary_stl(std::string_view bytes, const std::string& name, double scale, Model& model);
Diagnostics load_ascii_stl(std::string_view text, const std::string& name, double scale, Model& model);

}  // namespace gabarit
