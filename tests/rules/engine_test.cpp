#include "rules/engine.h"

#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checks/thickness.h"
#include "rules/read_value.h"
#include "rules/region.h"
#include "tests/rules/fake_checks.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

using fake::altitude;
using fake::at_least;
using fake::at_most;
using testing::ElementsAre;
using testing::HasSubstr;

// Two boxes of 10 mm on the ground at z = 5, 30 mm apart; the centroids of their floors lie on the ground.
Model two_boxes() {
  return shapes::model(
      shapes::joined(shapes::box({0, 0, 5}, {10, 10, 15}), shapes::box({40, 0, 5}, {50, 10, 15})));
}

Outcome run_rule(const Model& model, const Rule& rule) { return run(model, {fake::ruleset({rule})}); }

TEST(Engine, every_facet_over_the_limit_is_a_pass) {
  const Outcome outcome = run_rule(two_boxes(), fake::rule("r", altitude, at_most(10)));
  EXPECT_EQ(outcome.verdict, Verdict::pass);
  EXPECT_EQ(outcome.totals.passed, 1U);
  const RuleResult& result = outcome.results.at(0);
  EXPECT_EQ(result.facets_examined, 24U);
  EXPECT_DOUBLE_EQ(result.area_examined, 1200.0);
  EXPECT_TRUE(result.findings.empty());
  EXPECT_DOUBLE_EQ(result.worst.value, 10.0);
  EXPECT_EQ(result.reason, "");
}

TEST(Engine, failing_facets_become_one_finding_a_connected_patch) {
  const Outcome outcome = run_rule(two_boxes(), fake::rule("top", altitude, at_most(9)));
  EXPECT_EQ(outcome.verdict, Verdict::fail);
  const RuleResult& result = outcome.results.at(0);
  ASSERT_EQ(result.findings.size(), 2U);
  EXPECT_EQ(result.findings[0].id, "top/1");
  EXPECT_EQ(result.findings[1].id, "top/2");
  for (const Finding& finding : result.findings) {
    EXPECT_EQ(finding.verdict, Verdict::fail);
    EXPECT_EQ(finding.facets.size(), 2U);
    EXPECT_DOUBLE_EQ(finding.area, 100.0);
    EXPECT_DOUBLE_EQ(finding.centroid.z, 15.0);
    EXPECT_DOUBLE_EQ(finding.box.max.x - finding.box.min.x, 10.0);
  }
  EXPECT_DOUBLE_EQ(result.findings[0].centroid.x, 5.0);
  EXPECT_DOUBLE_EQ(result.findings[1].centroid.x, 45.0);
  EXPECT_EQ(result.facets_failed, 4U);
  EXPECT_DOUBLE_EQ(result.area_failed, 200.0);
}

TEST(Engine, findings_on_exact_surfaces_name_their_body_and_the_faces_they_lie_on) {
  Model model = two_boxes();
  ASSERT_EQ(model.bodies.size(), 1U);
  Brep& brep = model.brep.emplace();
  for (FacetId f = 0; f < model.mesh.facet_count(); ++f) brep.facets.emplace_back().face = f / 3;
  const Outcome outcome = run_rule(model, fake::rule("top", altitude, at_most(9)));
  const RuleResult& result = outcome.results.at(0);
  ASSERT_EQ(result.findings.size(), 2U);
  for (const Finding& finding : result.findings) {
    EXPECT_EQ(finding.body, model.bodies[0]);
    std::set<FaceId> faces;
    for (const FacetId f : finding.facets) faces.insert(f / 3);
    EXPECT_EQ(finding.faces, std::vector<FaceId>(faces.begin(), faces.end()));
  }
}

TEST(Engine, permuted_facets_give_the_same_findings) {
  const auto boxes = shapes::joined(shapes::gridded_box({0, 0, 0}, {10, 10, 10}, 2),
                                    shapes::gridded_box({40, 0, 0}, {50, 10, 20}, 2));
  const Rule rule = fake::rule("r", altitude, at_most(8.9));
  const RuleResult as_is = run_rule(shapes::model(boxes), rule).results.at(0);
  ASSERT_EQ(as_is.findings.size(), 2U);
  EXPECT_GT(as_is.findings[0].worst.value, as_is.findings[1].worst.value) << "worst first";
  for (std::uint32_t seed = 1; seed < 5; ++seed) {
    const RuleResult other = run_rule(shapes::model(shapes::permuted(boxes, seed)), rule).results.at(0);
    ASSERT_EQ(other.findings.size(), as_is.findings.size());
    for (std::size_t i = 0; i < other.findings.size(); ++i) {
      EXPECT_NEAR(other.findings[i].area, as_is.findings[i].area, 1e-9);
      EXPECT_EQ(other.findings[i].facets.size(), as_is.findings[i].facets.size());
      EXPECT_NEAR(other.findings[i].worst.value, as_is.findings[i].worst.value, 1e-9);
    }
  }
}

TEST(Engine, patches_join_through_t_junctions_but_not_at_a_corner) {
  using V = Vec3d;
  // One facet whose long edge meets two shorter ones; and one that only touches a corner.
  const Model joined = shapes::model({{V{0, 0, 0}, V{4, 0, 0}, V{2, 3, 0}},
                                      {V{0, 0, 0}, V{1, -2, 0}, V{2, 0, 0}},
                                      {V{2, 0, 0}, V{3, -2, 0}, V{4, 0, 0}},
                                      {V{4, 0, 0}, V{6, 0, 0}, V{5, 3, 0}}});
  Rule rule = fake::rule("r", altitude, at_least(1));
  const RuleResult result = run_rule(joined, rule).results.at(0);
  ASSERT_EQ(result.findings.size(), 2U);
  EXPECT_THAT(result.findings[0].facets, ElementsAre(0, 1, 2));
  EXPECT_THAT(result.findings[1].facets, ElementsAre(3));
}

TEST(Engine, a_limit_inside_the_bounds_is_undecided_and_says_why) {
  const Outcome outcome = run_rule(two_boxes(), fake::rule("r", altitude, at_most(10), 0.5));
  const RuleResult& result = outcome.results.at(0);
  EXPECT_EQ(outcome.verdict, Verdict::undecided);
  EXPECT_EQ(result.facets_undecided, 4U);
  ASSERT_EQ(result.findings.size(), 2U);
  EXPECT_EQ(result.findings[0].verdict, Verdict::undecided);
  EXPECT_EQ(result.reason, "Undecided on 4 of 24 facets (200.0 mm²): the limit lies between the bounds (4).");
}

TEST(Engine, fails_are_listed_before_undecided_patches_and_name_the_worst) {
  const Model model = shapes::model(
      shapes::joined(shapes::box({0, 0, 0}, {10, 10, 10}), shapes::box({40, 0, 0}, {50, 10, 11})));
  const RuleResult result = run_rule(model, fake::rule("r", altitude, at_most(10), 0.5)).results.at(0);
  EXPECT_EQ(result.verdict, Verdict::fail);
  ASSERT_EQ(result.findings.size(), 2U);
  EXPECT_EQ(result.findings[0].verdict, Verdict::fail);
  EXPECT_EQ(result.findings[1].verdict, Verdict::undecided);
  EXPECT_DOUBLE_EQ(result.worst.value, 11.0);
}

TEST(Engine, ignored_regions_still_make_the_rule_fail) {
  Rule rule = fake::rule("r", altitude, at_most(9));
  rule.ignore_area = 100.5;
  const RuleResult result = run_rule(two_boxes(), rule).results.at(0);
  EXPECT_EQ(result.verdict, Verdict::fail);
  EXPECT_TRUE(result.findings.empty());
  EXPECT_EQ(result.findings_ignored, 2U);
  EXPECT_EQ(result.facets_failed, 4U);
}

TEST(Engine, an_empty_region_is_not_applicable_and_says_where_it_looked) {
  Rule rule = fake::rule("r", altitude, at_most(9));
  rule.where = fake::where(fake::beyond, fake::number("from", 1000));
  const Outcome outcome = run_rule(two_boxes(), rule);
  EXPECT_EQ(outcome.verdict, Verdict::not_applicable);
  EXPECT_EQ(outcome.results.at(0).reason,
            "No facet is selected: the rule looks at facets where it lies at the far end.");
  EXPECT_FALSE(outcome.results.at(0).has_worst);
}

TEST(Engine, a_facet_that_is_only_maybe_selected_is_undecided_not_failed) {
  Rule rule = fake::rule("r", altitude, at_most(-1));
  rule.where = fake::where(fake::beyond, fake::number("from", 50));
  const RuleResult result = run_rule(two_boxes(), rule).results.at(0);  // the far side at x = 50: maybe
  EXPECT_EQ(result.verdict, Verdict::undecided);
  EXPECT_EQ(result.facets_undecided, 2U);
  EXPECT_THAT(result.reason, HasSubstr("it is not certain that the rule looks there (2)"));
}

TEST(Engine, a_rule_that_throws_is_not_run_and_the_others_still_run) {
  Rule stuck = fake::rule("stuck", altitude, at_most(10));
  stuck.where = fake::where(fake::broken_selector);
  const Outcome outcome =
      run(two_boxes(), {fake::ruleset({fake::rule("lost", fake::broken, at_most(10)),
                                       fake::rule("greedy", fake::greedy, at_most(10)), stuck,
                                       fake::rule("forgetful", fake::forgetful, at_most(10)),
                                       fake::rule("fine", altitude, at_most(10))})});
  EXPECT_EQ(outcome.verdict, Verdict::not_run);
  EXPECT_EQ(outcome.totals.not_run, 4U);
  EXPECT_EQ(outcome.totals.passed, 1U);
  EXPECT_EQ(outcome.results.at(0).reason, "The check stopped: the ball was lost.");
  EXPECT_EQ(outcome.results.at(1).reason, "There was not enough memory.");
  EXPECT_EQ(outcome.results.at(2).reason, "The check stopped: the probe got stuck.");
  EXPECT_EQ(outcome.results.at(3).reason,
            "The check stopped: `forgetful` measured 23 facets of the 24 selected ones.");
  EXPECT_EQ(outcome.results.at(3).facets_examined, 0U);
}

TEST(Engine, facets_without_area_are_noted_and_broken_ones_are_undecided) {
  auto triangles = shapes::box({0, 0, 0}, {10, 10, 10});
  triangles.push_back({Vec3d{0, 0, 0}, Vec3d{5, 0, 0}, Vec3d{10, 0, 0}});
  const RuleResult fine =
      run_rule(shapes::model(triangles), fake::rule("r", altitude, at_most(10))).results[0];
  EXPECT_EQ(fine.verdict, Verdict::pass);
  EXPECT_EQ(fine.facets_examined, 12U);
  EXPECT_THAT(fine.field.notes,
              ElementsAre("One selected facet has no area: it covers no surface and was not judged."));
  Model model = shapes::model(triangles);
  model.mesh.facets.back()[1] = static_cast<VertexId>(model.mesh.vertices.size());
  model.mesh.vertices.push_back({NAN, 0, 0});
  const RuleResult broken = run_rule(model, fake::rule("r", altitude, at_most(10))).results[0];
  EXPECT_EQ(broken.verdict, Verdict::undecided);
  EXPECT_TRUE(std::isnan(broken.findings.at(0).worst.value));
}

TEST(Engine, the_ground_is_the_lowest_vertex_along_up) {
  RuleSet rules = fake::ruleset({fake::rule("r", altitude, at_most(10))});
  EXPECT_DOUBLE_EQ(run(two_boxes(), {rules}).setups.at(0).frame.ground, 5.0);
  rules.up = {0, 0, -1};
  EXPECT_DOUBLE_EQ(run(two_boxes(), {rules}).setups.at(0).frame.ground, -15.0);
  rules.ground = Ground::height;
  rules.ground_height = 3;
  EXPECT_DOUBLE_EQ(run(two_boxes(), {rules}).setups.at(0).frame.ground, 3.0);
}

TEST(Engine, the_users_sag_counts_before_the_models_and_that_before_the_rule_sets) {
  RuleSet rules = fake::ruleset({});
  rules.sag = 0.3;
  Model model = two_boxes();
  model.sag = 0.2;
  EXPECT_DOUBLE_EQ(run(model, {rules}, {.sag = 0.4}).setups.at(0).sag, 0.4);
  EXPECT_DOUBLE_EQ(run(model, {rules}).setups.at(0).sag, 0.2);
  model.sag.reset();
  EXPECT_DOUBLE_EQ(run(model, {rules}).setups.at(0).sag, 0.3);
  rules.sag.reset();
  EXPECT_DOUBLE_EQ(run(model, {rules}).setups.at(0).sag, 0.1);
}

TEST(Engine, only_the_asked_rules_are_planned) {
  const RuleSet rules =
      fake::ruleset({fake::rule("a", altitude, at_most(1)), fake::rule("b", altitude, at_most(10))});
  const Outcome outcome = run(two_boxes(), {rules}, {.only = {"b"}});
  EXPECT_EQ(outcome.totals.planned, 1U);
  EXPECT_EQ(outcome.verdict, Verdict::pass);
  EXPECT_EQ(run(two_boxes(), {fake::ruleset({})}).verdict, Verdict::not_run) << "nothing ran, nothing passed";
}

TEST(Engine, unknown_and_shared_rule_ids_are_found_before_a_run) {
  const RuleSet rules = fake::ruleset({fake::rule("column-r4", altitude, at_most(1))});
  const std::vector<RuleSet> twice{rules, rules};
  const std::vector<std::string> only{"column-r5"};
  const Diagnostics found = check_selection(twice, only);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found[0].message, HasSubstr("the rule id `column-r4` is already used"));
  EXPECT_EQ(found[1].message, "no rule has the id `column-r5`");
  EXPECT_EQ(found[1].hint, "did you mean `column-r4`? the only one known is `column-r4`");
  EXPECT_TRUE(check_selection(std::span(twice).first(1), {}).empty());
}

TEST(Engine, rules_over_the_same_facets_agree_with_rules_run_alone) {
  Rule strict = fake::rule("strict", altitude, at_most(9));
  strict.where = fake::where(fake::beyond, fake::number("from", 30));
  Rule mild = strict;
  mild.id = "mild";
  mild.require.limit = at_most(10);
  const Outcome both = run(two_boxes(), {fake::ruleset({strict, mild})});
  EXPECT_EQ(both.results.at(0).verdict, Verdict::fail);
  EXPECT_EQ(both.results.at(1).verdict, Verdict::pass);
  EXPECT_EQ(both.results.at(1).facets_examined, 12U);
}

TEST(Engine, progress_never_goes_back_and_ends_at_one) {
  double last = 0;
  const Outcome outcome = run(two_boxes(), {fake::ruleset({fake::rule("r", altitude, at_most(10))})},
                              {.progress = [&](const std::string&, double fraction) {
                                EXPECT_GE(fraction, last);
                                last = fraction;
                              }});
  EXPECT_EQ(outcome.verdict, Verdict::pass);
  EXPECT_DOUBLE_EQ(last, 1.0);
}

// A plate of twelve facets, 2 mm thick at one end and 12 mm at the other.
Verdict of_a_tapered_plate(const Limit& limit) {
  Rule rule = fake::rule("taper", thickness_measure, limit);
  fill_defaults(thickness_measure.parameters, rule.require.arguments);
  return run_rule(shapes::model(shapes::extrude({{0, 0}, {100, 0}, {100, 12}, {0, 2}}, 0, 60)), rule).verdict;
}

TEST(Engine, a_facet_with_several_values_is_judged_by_the_one_that_the_limit_asks_for) {
  EXPECT_EQ(of_a_tapered_plate(at_least(3)), Verdict::fail);
  EXPECT_EQ(of_a_tapered_plate(at_least(1.5)), Verdict::pass);
  EXPECT_EQ(of_a_tapered_plate(at_most(50)), Verdict::fail) << "it is 60 and 100 mm long";
  EXPECT_EQ(of_a_tapered_plate(at_most(105)), Verdict::pass);
  const auto between = [](double low, double high) {
    return Limit{.kind = Limit::Kind::between, .low = low, .high = high};
  };
  EXPECT_EQ(of_a_tapered_plate(between(1.5, 105)), Verdict::pass);
  EXPECT_EQ(of_a_tapered_plate(between(3, 105)), Verdict::fail);
  EXPECT_EQ(of_a_tapered_plate(between(1.5, 90)), Verdict::fail);
}

}  // namespace
}  // namespace gabarit
