// The `require` of a rule: one measure and its limit.
#pragma once

#include "rules/catalogue.h"
#include "rules/rule_text.h"

namespace gabarit {

Requirement read_requirement(RuleText& text, const YamlNode& node, const Catalogue& catalogue);

}  // namespace gabarit
