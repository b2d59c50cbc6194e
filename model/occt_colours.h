// How a STEP or IGES file colours its faces, without XCAF and what that brings along.
#pragma once

#include <map>

#include <XSControl_Reader.hxx>

#include "model/brep.h"

namespace gabarit {

// By face without its placement (OcctNames::key). A face's own colour goes before that of its shell, solid or
// compound; an overriding style before the one that it overrides. Weak spot: colours that an assembly gives
// to single instances of a product are left out.
std::map<const void*, Colour> step_colours(const XSControl_Reader& reader);
// Colour numbers and colour definitions (type 314) of directory entries.
std::map<const void*, Colour> iges_colours(const XSControl_Reader& reader);

}  // namespace gabarit
