// The list of parts as JSON, for tools that compare a report with it.
#pragma once

#include <filesystem>

#include "examples/motorcycle/part.h"
#include "examples/motorcycle/tessellate.h"

namespace gabarit::motorcycle {

// Throws what OutputFile throws.
void write_parts(const Parts& parts, const Tessellation& tessellation, const std::filesystem::path& file);

}  // namespace gabarit::motorcycle
