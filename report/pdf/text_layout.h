// Text made to fit a width.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "report/pdf/fonts.h"
#include "report/pdf/style.h"

namespace gabarit::pdf {

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

// Lines of at most `width` mm, broken at spaces and after ideographs, within a word only when it is longer
// than a line. A line break in the text begins a new line. What goes beyond `most` lines is cut off with "…".
// Work and memory follow the lines that are kept, not the length of the text.
std::vector<std::string> wrap(Fonts& fonts, std::string_view text, const TextStyle& style, double width,
                              std::size_t most = any_number);

// The style made small enough for the whole line to take at most `width` mm: a number must not lose digits.
TextStyle shrunk(Fonts& fonts, std::string_view line, TextStyle style, double width);

// One line of at most `width` mm, cut off with "…".
std::string fitted(Fonts& fonts, std::string_view text, const TextStyle& style, double width);

}  // namespace gabarit::pdf
