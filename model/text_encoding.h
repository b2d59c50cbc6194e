// Text of unknown origin made safe to print.
#pragma once

#include <string>
#include <string_view>

namespace gabarit {

// The text with every byte that is not part of valid UTF-8 replaced by U+FFFD and every control character by
// a space.
std::string valid_utf8(std::string_view text);

}  // namespace gabarit
