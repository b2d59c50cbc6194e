// The frame and the sag that a rule set is checked with.
#pragma once

#include "rules/rule.h"

namespace gabarit {

// The ground is the lowest finite vertex along `up` when the rule set says so (0 without any). The sag in
// force is `sag` (the user's) when given, else what the model knows of itself, else the rule set's, else
// 0.1 mm.
Setup resolve_setup(const Model& model, const RuleSet& rules, std::optional<double> sag);

}  // namespace gabarit
