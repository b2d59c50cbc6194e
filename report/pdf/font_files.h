// Where the fonts of a report come from: those that came with the program, then the machine's usual folders.
#pragma once

#include <filesystem>
#include <vector>

namespace gabarit::pdf {

struct FontFiles {
  // DejaVu Sans; empty when it is not at hand.
  std::filesystem::path regular, bold, mono;
  // Faces for what DejaVu lacks, Japanese first. Outlines must be TrueType: libharu cannot embed others.
  std::vector<std::filesystem::path> fallbacks;
};

// Below `installed` (see report/installation.h), then in the machine's folders; when the environment's
// GABARIT_FONTS names folders (separated by `:`), only in these.
FontFiles find_usual_fonts(const std::filesystem::path& installed);
// Below the given folders, in their order.
FontFiles find_fonts(const std::vector<std::filesystem::path>& folders);

}  // namespace gabarit::pdf
