// From parts to a model: checked, tessellated, flattened.
#pragma once

#include "model/occt_guard.h"
#include "model/occt_parts.h"

namespace gabarit {

// Fills bodies, mesh, brep, sag and warnings of `model`. The sag asked for is options.sag, else 0.05 mm or a
// thousandth of the longest side of the box, whichever is less. Empty when all went well.
Diagnostics fill_model(std::vector<OcctPart> parts, OcctNames names, const std::string& file,
                       const LoadOptions& options, const Handle(OcctProgress) & progress, Model& model);

// The error of a file whose time is over.
Diagnostics out_of_time(const std::string& file, const LoadOptions& options);

}  // namespace gabarit
