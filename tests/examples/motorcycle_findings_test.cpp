// What the rules of the column find on the motorcycle as delivered, part by part, against the list.
#include <map>
#include <stdexcept>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "rules/engine.h"
#include "rules/read_rules.h"
#include "tests/examples/built.h"

namespace gabarit::motorcycle {
namespace {

const Outcome& outcome() {
  static const Outcome made = [] {
    auto rules = read_rules(GABARIT_SOURCE_DIR "/rules/library/motorcycle-column.yaml");
    if (!rules) throw std::runtime_error(to_string(rules.error().at(0)));
    return run(delivered().model, {*rules});
  }();
  return made;
}

struct Found {
  int violations = 0, undecided = 0;
};

std::map<std::string, Found> findings(std::size_t rule) {
  std::map<std::string, Found> by_part;
  for (const Finding& finding : outcome().results.at(rule).findings) {
    Found& found = by_part[finding.body];
    ++(finding.verdict == Verdict::fail ? found.violations : found.undecided);
  }
  return by_part;
}

std::string listed(std::size_t rule) {
  std::string all;
  for (const Finding& f : outcome().results.at(rule).findings)
    all += fmt::format("{} {} {:.3f} .. {:.3f}\n", f.id, f.body, f.worst.lower, f.worst.upper);
  return all;
}

// Facets with a sag of 0.1 mm tell a radius to about a quarter: nearer to the limit than that the check may
// leave a part undecided, but it neither passes one that violates nor fails one that does not.
constexpr double told_apart = 0.75;

void expect_as_listed(std::size_t rule, double limit) {
  auto all = findings(rule);
  for (const Part& part : delivered().parts) {
    const Found found = all[part.name];
    const bool violates = part.expectation == Expectation::violates && part.true_radius < limit;
    if (violates && part.true_radius <= told_apart * limit) {
      EXPECT_GT(found.violations, 0) << part.name;
    }
    if (violates) {
      EXPECT_GT(found.violations + found.undecided, 0) << part.name;
    } else {
      EXPECT_EQ(found.violations, 0) << part.name;
    }
    const bool touched = part.expectation == Expectation::violates || part.expectation == Expectation::round;
    if (!touched || part.true_radius >= limit / told_apart) {
      EXPECT_EQ(found.undecided, 0) << part.name;
    }
  }
  if (testing::Test::HasFailure()) ADD_FAILURE() << listed(rule);
}

TEST(MotorcycleFindings, r4_is_violated_by_the_parts_of_the_list_and_by_no_other) { expect_as_listed(0, 4); }

TEST(MotorcycleFindings, r3_2_is_violated_by_those_that_fall_short_of_it_too) { expect_as_listed(1, 3.2); }

TEST(MotorcycleFindings, the_rules_ran_on_the_facets_that_the_column_touches) {
  ASSERT_EQ(outcome().results.size(), 2U);
  EXPECT_EQ(outcome().verdict, Verdict::fail);
  for (const RuleResult& result : outcome().results) {
    EXPECT_EQ(result.verdict, Verdict::fail) << result.reason;
    EXPECT_GT(result.facets_examined, 1000U);
  }
}

}  // namespace
}  // namespace gabarit::motorcycle
