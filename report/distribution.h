// How the values of a rule's field are distributed over the examined area, in the units that people read.
#pragma once

#include <optional>
#include <vector>

#include "report/histogram.h"
#include "rules/outcome.h"

namespace gabarit {

// Shown value = inside value * factor.
double display_factor(const Requirement& require);
// A limit in display units.
Limit displayed(const Limit& limit, double factor);

// Bars over the display range. None when no facet has a finite value.
std::optional<Histogram> distribution(const RuleResult& result, const TriangleMesh& mesh);
// The same over a few ranges that are round multiples of the limit, finer beyond it than within.
std::optional<Histogram> coarse_distribution(const RuleResult& result, const TriangleMesh& mesh);

// A row of the table of ranges: which values, and how much of the area has them.
struct ValueRange {
  std::optional<double> from, to;  // without an end: below or above all others
  double area = 0, share = 0;      // mm², and of the whole area
  bool critical = false;           // beyond the limit
};

// The ranges, ascending, and what lies outside of them, if any. The shares add up to 1 with that of the area
// that has no value.
std::vector<ValueRange> value_ranges(const Histogram& coarse, const Limit& limit);

}  // namespace gabarit
