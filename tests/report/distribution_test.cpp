#include "report/distribution.h"

#include <gmock/gmock.h>

#include "tests/report/sample_report.h"
#include "tests/report/wall_report.h"

namespace gabarit {
namespace {

TEST(distribution, of_a_plate_has_its_faces_in_one_range_and_its_sides_in_another) {
  const WallReport wall(shapes::gridded_box({0, 0, 0}, {40, 30, 2}, 4), {Limit::Kind::at_least, 3, 0});
  const Histogram h = coarse_distribution(wall.rule(), wall.model.mesh).value();
  const std::vector<ValueRange> ranges = value_ranges(h, wall.rule().rule.require.limit);
  double faces = 0, sides = 0, share = 0;
  for (const ValueRange& r : ranges) {
    share += r.share;
    if (r.critical) faces += r.area;
    if (!r.critical) sides += r.area;
    EXPECT_EQ(r.critical, r.to.has_value() && *r.to <= 3);
  }
  EXPECT_NEAR(share, 1, 1e-12);
  EXPECT_NEAR(faces, 2 * 40 * 30, 1e-9);
  EXPECT_NEAR(sides, 2 * (40 + 30) * 2, 1e-9);
  EXPECT_NEAR(h.critical_area, 2 * 40 * 30, 1e-9);
  EXPECT_NEAR(h.minimum, 2, 1e-12);
  EXPECT_NEAR(h.maximum, 40, 1e-9);
  const double mean = (2 * 40 * 30 * 2 + 2 * 40 * 2 * 30 + 2 * 30 * 2 * 40.0) / (2400 + 280);
  EXPECT_NEAR(h.mean, mean, 1e-9) << "weighted by area";
}

TEST(distribution, ranges_meet_every_limit_and_follow_each_other) {
  SampleReport sample;
  for (const Limit& limit : {Limit{Limit::Kind::at_least, 4, 0}, Limit{Limit::Kind::at_most, 0, 4},
                             Limit{Limit::Kind::between, 2, 5}}) {
    RuleResult& rule = sample.rule("failing");
    rule.rule.require.limit = limit;
    const Histogram h = coarse_distribution(rule, sample.model.mesh).value();
    const std::vector<ValueRange> ranges = value_ranges(h, limit);
    for (std::size_t i = 1; i < ranges.size(); ++i) EXPECT_EQ(ranges[i - 1].to, ranges[i].from);
    for (const double bound : {limit.low, limit.high}) {
      if (bound == 0) continue;
      EXPECT_TRUE(
          std::any_of(ranges.begin(), ranges.end(), [&](const ValueRange& r) { return r.to == bound; }));
    }
  }
}

TEST(distribution, values_without_bound_are_over_the_last_range) {
  SampleReport sample;
  RuleResult& rule = sample.rule("failing");
  rule.field.value[0] = std::numeric_limits<double>::infinity();
  const Histogram h = coarse_distribution(rule, sample.model.mesh).value();
  const ValueRange last = value_ranges(h, rule.rule.require.limit).back();
  EXPECT_FALSE(last.to);
  EXPECT_NEAR(last.area, facet_area(sample.model.mesh, 0), 1e-12);
}

TEST(distribution, is_none_without_a_finite_value) {
  SampleReport sample;
  EXPECT_FALSE(distribution(sample.rule("absent"), sample.model.mesh));
  EXPECT_FALSE(coarse_distribution(sample.rule("broken"), sample.model.mesh));
}

}  // namespace
}  // namespace gabarit
