// What a STEP or IGES file calls the shapes that came out of it.
#pragma once

#include <map>
#include <string>

#include <TopoDS_Shape.hxx>
#include <XSControl_Reader.hxx>

namespace gabarit {

// By shape without its placement: instances of one product share them. UTF-8.
struct OcctNames {
  std::map<const void*, std::string> products;  // also those whose name is empty: where an assembly branches
  std::map<const void*, std::string> items;     // single solids, never empty

  static const void* key(const TopoDS_Shape& shape) { return shape.TShape().get(); }
};

// Of all that `reader` has transferred.
OcctNames step_names(const XSControl_Reader& reader);
OcctNames iges_names(const XSControl_Reader& reader);

}  // namespace gabarit
