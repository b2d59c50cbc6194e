// Checks whose answers are plain to see: the tests of the language and the engine need no geometry.
#pragma once

#include "rules/rule.h"

namespace gabarit::fake {

// Selects the facets whose centroid lies at x >= `from`; within 0.25 mm of it only maybe.
extern const Selector beyond;
// Selects nothing by itself but writes down the height band that it was handed, and a depth of 1 mm.
extern const Selector probe;
// Limits heights: {from, to}.
extern const Selector band;
// Throws.
extern const Selector broken_selector;

// The height of a facet's centroid above ground, give or take `margin`.
extern const Measure altitude;
// Throws std::bad_alloc, std::runtime_error, or leaves the last facet out.
extern const Measure greedy, broken, forgetful;

extern Interval band_seen;  // by the last `probe`

Where where(const Selector& selector, const Arguments& arguments = {});
Where all(std::vector<Where> children);
Where any(std::vector<Where> children);
Where none_of(Where child);
Arguments number(const std::string& name, double value);
Rule rule(const std::string& id, const Measure& measure, const Limit& limit, double margin = 0);
RuleSet ruleset(std::vector<Rule> rules);
Limit at_least(double low);
Limit at_most(double high);

}  // namespace gabarit::fake
