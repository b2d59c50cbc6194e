// Sentences about results that more than one output says.
#pragma once

#include <string>

#include "model/model.h"
#include "rules/outcome.h"

namespace gabarit {

// A value or bound as people read it, in the measure's display unit but without naming it: with digits enough
// to tell it from the limit.
std::string value_text(double value, const Requirement& require);
// "radius 2.013 mm (2.001 to 2.024), required: at least 4 mm, at (12.0, 3.5, 800.0)".
std::string worst_sentence(const Worst& worst, const Requirement& require);
// "face 12 'Top', a plane", counted from 0; empty when the model has no exact surfaces.
std::string face_text(const Model& model, FacetId facet);
// "faces 3, 4, 12 and 5 more"; empty when there is but one.
std::string faces_text(const Finding& finding);
// Why a rule has its verdict, and how much of the model it looked at.
std::string rule_sentence(const RuleResult& result);
// "of 1204 facets, 3345 mm² examined".
std::string examined_text(const RuleResult& result);

}  // namespace gabarit
