// Parameters of a selector or measure from a rule file.
#pragma once

#include <span>

#include "rules/keyed_map.h"

namespace gabarit {

// The parameters that stand in `map`, with defaults for the others. Complains at their places of wrong
// values, and at `at` of missing ones and of a `from` beyond its `to`. `name` is the selector's or measure's.
// Keys that are no parameters are left to the caller.
Arguments read_arguments(RuleText& text, std::span<const Parameter> parameters, KeyedMap& map,
                         const YamlNode& at, const std::string& name);

// The same of a value that stands alone for the first parameter: `body: "tank"`.
Arguments read_shorthand(RuleText& text, std::span<const Parameter> parameters, const YamlNode& value,
                         const YamlNode& at, const std::string& name);

}  // namespace gabarit
