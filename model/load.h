// Reads a model from a file; the format follows from the extension, then from the content.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "model/model.h"
#include "model/result.h"

namespace gabarit {

struct LoadOptions {
  std::optional<Unit> unit = {};   // of the coordinates in the file; not given: millimetres, said as assumed
  std::optional<double> sag = {};  // mm; of the facets in the file, or of those made of exact surfaces
  std::optional<double> facet_size = {};  // mm; no facet made of exact surfaces has a longer side
  int threads = 0;                        // 0: all cores
  double time_limit = 900;                // seconds that a STEP or IGES file may take
  std::function<void(const char* stage, double fraction)> progress = {};  // may be empty
};

// Errors name the file, the place (byte or line) and what to do. A model without a single measurable facet is
// an error; defects are not, they are counted in the model.
Result<Model> load(const std::filesystem::path& file, const LoadOptions& options = {});

}  // namespace gabarit
