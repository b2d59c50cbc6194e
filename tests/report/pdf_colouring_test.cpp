#include <limits>

#include <gmock/gmock.h>

#include "report/pdf/colouring.h"
#include "tests/report/sample_report.h"
#include "tests/report/wall_report.h"

namespace gabarit::pdf {
namespace {

TEST(colouring, of_a_probe_is_by_verdict) {
  SampleReport sample;
  RuleResult& failing = sample.rule("failing");
  failing.region.depth.assign(12, 0);
  const Colouring c = colouring(sample.model.mesh, failing);
  EXPECT_FALSE(c.by_value);
  EXPECT_EQ(c.facets[0], palette::fail);
  EXPECT_EQ(c.facets[4], palette::pass);
  EXPECT_EQ(c.facets[1], palette::out_of_reach);
}

RuleResult measured_everywhere(const SampleReport& sample, double value) {
  RuleResult result = sample_result("wall", Verdict::pass);
  for (FacetId f = 0; f < sample.model.mesh.facet_count(); ++f) {
    result.field.facets.push_back(f);
    result.field.value.push_back(value);
    result.facet_verdicts.push_back(FacetVerdict::pass);
  }
  return result;
}

TEST(colouring, of_a_finite_measure_over_the_model_is_by_value) {
  const SampleReport sample;
  RuleResult result = measured_everywhere(sample, 5);
  result.field.value[0] = 1;
  result.facet_verdicts[1] = FacetVerdict::undecided;
  const Colouring c = colouring(sample.model.mesh, result);
  EXPECT_TRUE(c.by_value);
  EXPECT_EQ(c.facets[0], c.scale.colour(1));
  EXPECT_NE(c.facets[0], c.facets[2]);
  EXPECT_EQ(c.facets[1], palette::undecided);
}

TEST(colouring, of_a_radius_that_flat_parts_do_not_have_is_by_verdict) {
  const SampleReport sample;
  EXPECT_FALSE(
      colouring(sample.model.mesh, measured_everywhere(sample, std::numeric_limits<double>::infinity()))
          .by_value);
}

TEST(colouring, of_gaps_is_by_value_though_most_of_a_part_has_none) {
  const auto blocks = shapes::joined(shapes::gridded_box({0, 0, 0}, {20, 20, 10}, 5),
                                     shapes::gridded_box({0, 0, 10.6}, {20, 20, 20}, 5));
  const WallReport wall(blocks, {Limit::Kind::at_least, 1, 0}, "clearance");
  const Colouring c = colouring(wall.model.mesh, wall.rule());
  EXPECT_TRUE(c.by_value);
  for (std::size_t i = 0; i < wall.rule().field.size(); ++i) {
    const double value = wall.rule().field.value[i];
    EXPECT_EQ(c.facets[wall.rule().field.facets[i]], c.scale.colour(value > 100 ? c.scale.high : value));
  }
}

TEST(colouring, takes_the_colours_that_are_asked_for) {
  const WallReport wall(shapes::box({0, 0, 0}, {20, 20, 2}), {Limit::Kind::at_least, 3, 0});
  const Colouring c = colouring(wall.model.mesh, wall.rule(), ColourMap::red_to_blue);
  EXPECT_EQ(c.scale.map, ColourMap::red_to_blue);
  EXPECT_EQ(c.facets[0], c.scale.colour(wall.rule().field.value[0]));
}

TEST(marks, keep_what_fails_or_is_undecided_for_any_rule_visible) {
  SampleReport sample;
  const auto of_all = pdf::marks(sample.model.mesh, sample.outcome.results);
  EXPECT_EQ(of_all[0], 2);  // fails one rule, undecided for another
  EXPECT_EQ(of_all[1], 0);
  EXPECT_EQ(of_all[2], 2);
  EXPECT_EQ(of_all[4], 0);
  const auto of_one = pdf::marks(sample.model.mesh, {&sample.rule("undecided"), 1});
  EXPECT_EQ(of_one[0], 1);
  EXPECT_EQ(of_one[2], 0);
}

TEST(verdict_colours, the_gravest_verdict_of_a_facet_shows) {
  const SampleReport sample;
  const std::vector<Rgb> colours = verdict_colours(sample.model.mesh, sample.outcome);
  EXPECT_EQ(colours[0], palette::fail);
  EXPECT_EQ(colours[4], palette::pass);
  EXPECT_EQ(colours[1], palette::out_of_reach);
}

}  // namespace
}  // namespace gabarit::pdf
