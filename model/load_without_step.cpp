// What stands in for the loaders in a build without OpenCASCADE.
#include "model/load_step.h"

namespace gabarit {

static Diagnostics not_built(const std::filesystem::path& file) {
  return {{.file = file.string(),
           .message = "STEP and IGES files cannot be read: this program was built without OpenCASCADE "
                      "(-DGABARIT_STEP=OFF); export the model as STL, or build with it"}};
}

bool step_can_be_read() { return false; }

Diagnostics load_step(const std::filesystem::path& file, std::string_view, const LoadOptions&, Model&) {
  return not_built(file);
}
Diagnostics load_iges(const std::filesystem::path& file, std::string_view, const LoadOptions&, Model&) {
  return not_built(file);
}

}  // namespace gabarit
