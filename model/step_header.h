// What the text of a STEP file says before any geometry is read.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/result.h"

namespace gabarit {

// Empty when the file begins and ends as ISO 10303-21 wants. A file that was cut off must not be read as far
// as it goes: parts would be missing without a word.
Diagnostics step_errors(std::string_view bytes, const std::string& file);
// "STEP" and the name of the schema, such as "STEP (AUTOMOTIVE_DESIGN)".
std::string step_format(std::string_view bytes);
// The names of its conversion based units, such as "inch" and "degree", in the order of the file.
std::vector<std::string> step_conversion_units(std::string_view bytes);
// How many solids and shells are given as facets alone (AP242, ISO 10303-42 tessellated_solid and
// tessellated_shell), without a link to exact surfaces in the same file.
std::size_t step_bodies_of_facets(std::string_view bytes);

}  // namespace gabarit
