// The curves that bound OpenCASCADE's faces in their parameter planes.
#pragma once

#include <functional>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "model/brep.h"

namespace gabarit {

// Adds the trimming of the next face that has none. Computes curves that the file left out.
void add_trim(const TopoDS_Face& face, const std::function<EdgeId(const TopoDS_Edge&)>& number, Brep& brep);

}  // namespace gabarit
