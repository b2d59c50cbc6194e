// A binary STL written facet by facet.
#pragma once

#include <array>
#include <cstdint>

#include "gpu/vec3.h"
#include "report/output_file.h"

namespace gabarit::motorcycle {

// `facets` must be announced right: the caller knows the count before it writes. Throws what OutputFile
// throws.
void write_stl_header(OutputFile& file, std::uint32_t facets);
void write_stl_facet(OutputFile& file, const std::array<Vec3f, 3>& corners);

}  // namespace gabarit::motorcycle
