// Curves and surfaces of OpenCASCADE as plain arrays.
#pragma once

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include "model/brep.h"

namespace gabarit {

// Appends the curve with all that it needs and gives its number. Kinds that a Brep does not have (offset
// curves) become a spline, within 1e-6 mm where OpenCASCADE gets there, and are counted. Throws
// Standard_Failure when that is impossible.
std::uint32_t add_curve(Brep& brep, const Handle(Geom_Curve) & curve);
// The same for a surface. `range` is where it is needed: what is approximated is approximated there.
std::uint32_t add_surface(Brep& brep, const Handle(Geom_Surface) & surface, const ParameterBox& range);

}  // namespace gabarit
