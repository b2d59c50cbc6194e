// Selects bodies by name.
#pragma once

#include <string_view>

#include "checks/check.h"

namespace gabarit {

extern const Selector body_selector;

// Whether the whole name fits: `*` stands for any characters, `?` for one (of UTF-8, not one byte); case
// counts.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace gabarit
