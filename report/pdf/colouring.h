// The colour of every facet in the pictures of a rule.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/triangle_mesh.h"
#include "report/palette.h"
#include "rules/outcome.h"

namespace gabarit::pdf {

struct Colouring {
  // By value on a scale that marks the limit, or by verdict. Thickness and clearance are shown by value;
  // other measures when no probe chose the facets and more than half of the model's area has a finite value:
  // on flat parts a radius has none.
  bool by_value = false;
  ColourScale scale;        // of values, in display units
  std::vector<Rgb> facets;  // one a facet of the model
};

// `map` is used where values are shown.
Colouring colouring(const TriangleMesh& mesh, const RuleResult& result, ColourMap map = ColourMap::by_limit);
// By the gravest verdict of all rules.
std::vector<Rgb> verdict_colours(const TriangleMesh& mesh, const Outcome& outcome);
Rgb facet_colour(FacetVerdict verdict);
// What must stay visible in a picture however small it is, one a facet: see Drawing::marked.
std::vector<std::uint8_t> marks(const TriangleMesh& mesh, std::span<const RuleResult> results);

}  // namespace gabarit::pdf
