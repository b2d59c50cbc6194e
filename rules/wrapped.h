// Text in lines of a given width.
#pragma once

#include <string>

namespace gabarit {

// Paragraphs (separated by empty lines) broken at spaces to at most `width` characters, every line indented
// by `indent` spaces; a line that begins with "- " begins a line. Words are never broken. Ends with a line
// end.
std::string wrapped(const std::string& text, int width, int indent = 0);

}  // namespace gabarit
