// Text of unknown origin as code points that may be drawn on one line.
#pragma once

#include <string>
#include <string_view>

namespace gabarit::pdf {

// Of UTF-8. Bytes that are no UTF-8 and controls, those of writing direction too, become U+FFFD; tabs and
// line breaks become spaces.
std::u32string code_points(std::string_view text);

void append_utf8(std::string& text, char32_t code);
std::string utf8(std::u32string_view codes);

// Nothing of the code point is seen, such as a joiner or a variation selector: it may be left out.
bool is_invisible(char32_t code);

// Written from right to left, such as Hebrew and Arabic.
bool is_right_to_left(char32_t code);

// A line may end after an ideograph or a kana without a space.
bool is_ideograph(char32_t code);

}  // namespace gabarit::pdf
