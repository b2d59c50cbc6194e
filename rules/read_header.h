// What stands above the rules: what the set is, and how the model stands.
#pragma once

#include "rules/keyed_map.h"

namespace gabarit {

// Reads every key but `gabarit` and `rules`.
void read_header(RuleText& text, KeyedMap& map, RuleSet& rules);

// An id at `node`; complains of one that can't be.
std::string read_identifier(RuleText& text, KeyedMap& map);

}  // namespace gabarit
