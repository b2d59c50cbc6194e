// From a rule file to a verdict: boxes whose edges are rounded a little less and a little more than R4.
#include <cmath>

#include <gtest/gtest.h>

#include "rules/engine.h"
#include "rules/read_rules.h"
#include "tests/checks/fillets.h"

namespace gabarit {
namespace {

constexpr const char* r4 = R"(gabarit: 1
id: rounded
title: Everything is rounder than R4
revision: "1"
sag: 0.1 mm
rules:
  - id: r4
    title: Everything is rounded by at least R4
    require:
      radius: {at least: 4 mm}
)";

RuleResult checked(double radius, int steps) {
  const auto rules = read_rules_text(r4, "r4.yaml");
  EXPECT_TRUE(rules);
  const Model model = shapes::model(fillets::rounded_box(60, radius, steps));
  return run(model, {*rules}).results.at(0);
}

TEST(RadiusRule, a_box_rounded_by_r3_9_fails_and_names_the_radius) {
  const RuleResult result = checked(3.9, 8);
  EXPECT_EQ(result.verdict, Verdict::fail);
  EXPECT_NEAR(result.worst.value, 3.9, 0.1);
  EXPECT_LT(result.worst.upper, 4);
}

TEST(RadiusRule, a_box_rounded_by_r4_1_passes_whole) {
  const RuleResult result = checked(4.1, 8);
  EXPECT_EQ(result.verdict, Verdict::pass) << result.reason;
  EXPECT_EQ(result.facets_failed + result.facets_undecided, 0U);
}

TEST(RadiusRule, a_box_rounded_by_r5_passes_at_the_sag_that_exporters_use) {
  EXPECT_EQ(checked(5, 4).verdict, Verdict::pass);
}

}  // namespace
}  // namespace gabarit
