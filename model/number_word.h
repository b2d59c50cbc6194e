// Numbers as mesh files write them, whatever the locale.
#pragma once

#include <cstdint>
#include <string_view>

namespace gabarit {

// The whole word is one decimal number, `nan` or `inf`; the spellings of old Windows runtimes (`1.#QNAN`,
// `-1.#INF`) count too. Too large is infinite, too small is 0. False for anything else.
bool read_number(std::string_view word, double& value);

// The whole word is one decimal integer that fits.
bool read_integer(std::string_view word, std::int64_t& value);

}  // namespace gabarit
