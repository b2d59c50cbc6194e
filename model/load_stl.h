// STL, binary and ASCII (3D Systems, StereoLithography Interface Specification, 1988).
#pragma once

#include "model/model.h"

namespace gabarit {

enum class StlKind { binary, ascii, neither };
// Many binary files begin with "solid" and some ASCII files with a comment: the size decides first, then the
// words.
StlKind stl_kind(std::string_view bytes);
// What only an STL file does, whatever its name: its size is the one that its header announces, or its first
// word that is no comment is "solid" or "facet".
bool has_announced_size(std::string_view bytes);
bool begins_as_ascii_stl(std::string_view text);

// Fill mesh, bodies, format and warnings of `model`; empty when all went well. Coordinates are multiplied by
// `scale`.
Diagnostics load_binary_stl(std::string_view bytes, const std::string& name, double scale, Model& model);
Diagnostics load_ascii_stl(std::string_view text, const std::string& name, double scale, Model& model);

}  // namespace gabarit
