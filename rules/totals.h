// How many rules ended how, and what that makes of the whole.
#pragma once

#include <span>

#include "rules/outcome.h"

namespace gabarit {

Totals count(std::span<const RuleResult> results);
// fail > not_run > undecided > pass > not_applicable, whatever the severities; not_run without any rule.
Verdict overall(std::span<const RuleResult> results);

}  // namespace gabarit
