// What a STEP or IGES file calls the shapes that came out of it, and how it colours them.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>
#include <XSControl_Reader.hxx>

#include "model/brep.h"

namespace gabarit {

// By shape without its placement: instances of one product share them. UTF-8.
struct OcctNames {
  std::map<const void*, std::string> products;  // also those whose name is empty: where an assembly branches
  std::map<const void*, std::string> items;     // single solids, shells and faces, never empty
  std::map<const void*, Colour> colours;        // of faces

  static const void* key(const TopoDS_Shape& shape) { return shape.TShape().get(); }

  // What is known of the solids, shells and faces of `before` holds as well for what became of them:
  // `successor(shape)`, which may be null, or hold several.
  void hand_on(const TopoDS_Shape& before, const std::function<TopoDS_Shape(const TopoDS_Shape&)>& successor);
  // The labels of the faces of `shape` in the order of TopExp_Explorer, appended to `labels`.
  void add_labels(const TopoDS_Shape& shape, std::vector<FaceLabel>& labels) const;
};

// Of all that `reader` has transferred.
OcctNames step_names(const XSControl_Reader& reader);
OcctNames iges_names(const XSControl_Reader& reader);

}  // namespace gabarit
