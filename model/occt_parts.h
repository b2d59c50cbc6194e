// The parts of an assembly, placed and named.
#pragma once

#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "model/occt_names.h"

namespace gabarit {

struct OcctPart {
  std::string name;    // UTF-8, never empty
  TopoDS_Shape shape;  // a solid, an open shell or a compound of loose faces; its placement is rigid
  bool solid = false;
};

// Of all that `reader` has transferred, in the order of the file. A part is named after its product; solids
// that share a product, "product/solid name" where the file names them, else all alike. `fallback` names what
// has no name. `names` learns of the shapes that are made anew for mirrored instances.
std::vector<OcctPart> parts(const XSControl_Reader& reader, OcctNames& names, const std::string& fallback);

}  // namespace gabarit
