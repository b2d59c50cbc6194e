// Sentences about results that more than one output says.
#pragma once

#include <string>

#include "rules/outcome.h"

namespace gabarit {

// A value or bound as people read it, in the measure's display unit but without naming it: with digits enough
// to tell it from the limit.
std::string value_text(double value, const Requirement& require);
// "radius 2.013 mm (2.001 to 2.024), required: at least 4 mm, at (12.0, 3.5, 800.0)".
std::string worst_sentence(const Worst& worst, const Requirement& require);
// Why a rule has its verdict, and how much of the model it looked at.
std::string rule_sentence(const RuleResult& result);
// "of 1204 facets, 3345 mm² examined".
std::string examined_text(const RuleResult& result);

}  // namespace gabarit
