// From a measured field to the verdict of a rule.
#pragma once

#include "rules/outcome.h"

namespace gabarit {

// Fills everything of `result` that follows from its rule, region and field: facet verdicts, counts, areas,
// findings, the worst place, the rule's verdict and its reason. Facets without area (finite, but degenerate)
// cover no surface: they are counted in a note and not judged. Throws std::logic_error when the field does
// not hold exactly the selected facets.
void judge_field(const Model& model, RuleResult& result);

}  // namespace gabarit
