// STEP and IGES files through OpenCASCADE: ISO 10303-21 with AP203, AP214 or AP242, and IGES 5.3.
#pragma once

#include <string_view>

#include "model/load.h"

namespace gabarit {

// False in a build without OpenCASCADE; then both loaders say so.
bool step_can_be_read();

// Fill everything of `model` but file and hash; empty when all went well. The exact surfaces stay in
// `model.brep`, the facets are made of them: no further from them than `model.sag`. One body a solid, one for
// every open shell, one for the loose faces of a part. Weak spots: layers and annotations are not
// read; tessellated geometry in AP242 is not known to OpenCASCADE 7.6.
Diagnostics load_step(const std::filesystem::path& file, std::string_view bytes, const LoadOptions& options,
                      Model& model);
Diagnostics load_iges(const std::filesystem::path& file, std::string_view bytes, const LoadOptions& options,
                      Model& model);

}  // namespace gabarit
