// Whether a file is a font that libharu can embed.
#pragma once

#include <filesystem>

namespace gabarit::pdf {

// The file (or the first font of a collection) has TrueType outlines and a Unicode table, and every table
// lies within the file. libharu looks for less, and crashes on what it did not expect.
bool is_embeddable(const std::filesystem::path& font);

}  // namespace gabarit::pdf
