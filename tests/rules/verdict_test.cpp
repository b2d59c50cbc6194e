#include "rules/verdict.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Limit at_least(double low) { return {.kind = Limit::Kind::at_least, .low = low, .high = 0}; }
Limit at_most(double high) { return {.kind = Limit::Kind::at_most, .low = 0, .high = high}; }

TEST(Verdict, a_lower_limit_is_met_when_the_lower_bound_reaches_it) {
  EXPECT_EQ(judge(4.0, 4.2, at_least(4), Selected::yes), FacetVerdict::pass);
  EXPECT_EQ(judge(std::nextafter(4.0, 0.0), 4.2, at_least(4), Selected::yes), FacetVerdict::undecided);
}

TEST(Verdict, a_lower_limit_is_broken_when_the_upper_bound_stays_under_it) {
  EXPECT_EQ(judge(3.0, std::nextafter(4.0, 0.0), at_least(4), Selected::yes), FacetVerdict::fail);
  EXPECT_EQ(judge(3.0, 4.0, at_least(4), Selected::yes), FacetVerdict::undecided);
}

TEST(Verdict, an_upper_limit_mirrors_a_lower_one) {
  EXPECT_EQ(judge(2.0, 3.0, at_most(3), Selected::yes), FacetVerdict::pass);
  EXPECT_EQ(judge(3.5, infinity, at_most(3), Selected::yes), FacetVerdict::fail);
  EXPECT_EQ(judge(2.0, 3.5, at_most(3), Selected::yes), FacetVerdict::undecided);
}

TEST(Verdict, between_needs_both_sides) {
  const Limit limit{.kind = Limit::Kind::between, .low = 1, .high = 3};
  EXPECT_EQ(judge(1.0, 3.0, limit, Selected::yes), FacetVerdict::pass);
  EXPECT_EQ(judge(0.1, 0.9, limit, Selected::yes), FacetVerdict::fail);
  EXPECT_EQ(judge(3.1, 4.0, limit, Selected::yes), FacetVerdict::fail);
  EXPECT_EQ(judge(0.9, 2.0, limit, Selected::yes), FacetVerdict::undecided);
}

TEST(Verdict, a_facet_that_is_only_maybe_selected_never_fails) {
  EXPECT_EQ(judge(0.0, 1.0, at_least(4), Selected::maybe), FacetVerdict::undecided);
  EXPECT_EQ(judge(5.0, 6.0, at_least(4), Selected::maybe), FacetVerdict::pass);
  EXPECT_EQ(judge(0.0, 1.0, at_least(4), Selected::no), FacetVerdict::not_examined);
}

TEST(Verdict, bounds_that_are_not_numbers_never_pass) {
  EXPECT_EQ(judge(NAN, NAN, at_least(4), Selected::yes), FacetVerdict::undecided);
  EXPECT_EQ(judge(0.0, infinity, at_least(4), Selected::yes), FacetVerdict::undecided);
}

}  // namespace
}  // namespace gabarit
