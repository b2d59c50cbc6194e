// The `where` of a rule.
#pragma once

#include "rules/catalogue.h"
#include "rules/rule_text.h"

namespace gabarit {

// One selector a map; several stand in a list under `all:` or `any:`, one under `not:`. Complains of
// everything wrong; what it then returns is of no use.
Where read_where(RuleText& text, const YamlNode& node, const Catalogue& catalogue);

}  // namespace gabarit
