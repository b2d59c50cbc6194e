// Faces, edges and vertices of OpenCASCADE shapes as plain arrays.
#pragma once

#include <TopoDS_Shape.hxx>

#include "model/brep.h"

namespace gabarit {

// Appends the faces of the shape in the order of TopExp_Explorer, its edges and vertices in that of
// TopExp::MapShapes, with their surfaces and curves in place. Throws Standard_Failure when a surface cannot
// be had.
void add_topology(const TopoDS_Shape& shape, std::uint32_t body, Brep& brep);

}  // namespace gabarit
