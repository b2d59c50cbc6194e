#include "report/histogram.h"

#include <cmath>
#include <numeric>
#include <random>

#include <gmock/gmock.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

const Limit at_least_4{Limit::Kind::at_least, 4, 0};
const Limit at_most_4{Limit::Kind::at_most, 0, 4};

const HistogramBin& bin_at(const Histogram& h, double value) {
  for (const HistogramBin& bin : h.bins) {
    if (bin.from <= value && value < bin.to) return bin;
  }
  throw std::out_of_range("no such bin");
}

double sum(const Histogram& h) {
  double total = h.area_below + h.area_above + h.area_without;
  for (const HistogramBin& bin : h.bins) total += bin.area;
  return total;
}

TEST(histogram, weighs_by_area_and_tells_the_figures) {
  const std::vector<double> values{1, 3, 5, 9};
  const std::vector<double> areas{10, 20, 30, 40};
  const Histogram h = histogram(values, areas, {0, 10}, at_least_4, 10);
  EXPECT_EQ(h.bins.size(), 10U);
  EXPECT_EQ(bin_at(h, 3.5).area, 20);
  EXPECT_EQ(bin_at(h, 3.5).facets, 1U);
  EXPECT_EQ(h.minimum, 1);
  EXPECT_EQ(h.maximum, 9);
  EXPECT_DOUBLE_EQ(h.mean, (10 + 60 + 150 + 360) / 100.0);
  EXPECT_EQ(h.critical_area, 30);
  EXPECT_EQ(h.critical_facets, 2U);
  EXPECT_DOUBLE_EQ(h.share(h.critical_area), 0.3);
}

TEST(histogram, has_the_limit_as_an_edge_however_crooked) {
  const Limit crooked{Limit::Kind::at_least, 3.217, 0};
  const Histogram h = histogram({}, {}, {0, 10}, crooked, 40);
  EXPECT_EQ(bin_at(h, 3.217).from, 3.217);
  for (const HistogramBin& bin : h.bins) EXPECT_EQ(bin.critical, bin.to <= 3.217);
}

TEST(histogram, has_both_limits_as_edges_and_one_width) {
  const Limit between{Limit::Kind::between, 1.13, 2.94};
  const Histogram h = histogram({}, {}, {0, 5}, between, 40);
  EXPECT_EQ(bin_at(h, 1.13).from, 1.13);
  EXPECT_EQ(bin_at(h, 2.94).from, 2.94);
  for (const HistogramBin& bin : h.bins) {
    EXPECT_NEAR(bin.to - bin.from, h.bins[0].to - h.bins[0].from, 1e-12);
    EXPECT_EQ(bin.critical, bin.to <= 1.13 || bin.from >= 2.94);
  }
}

TEST(histogram, puts_a_value_on_the_limit_on_the_side_that_passes) {
  const std::vector<double> value{4};
  const std::vector<double> area{1};
  for (const Limit& limit : {at_least_4, at_most_4}) {
    const Histogram h = histogram(value, area, {0, 10}, limit);
    EXPECT_EQ(h.critical_area, 0);
    for (const HistogramBin& bin : h.bins) EXPECT_TRUE(bin.area == 0 || !bin.critical);
  }
}

TEST(histogram, counts_what_is_outside_unlimited_or_without_a_value_apart) {
  const std::vector<double> values{-1, 5, 100, INFINITY, NAN};
  const std::vector<double> areas{1, 2, 4, 8, 16};
  const Histogram h = histogram(values, areas, {0, 10}, at_most_4);
  EXPECT_EQ(h.area_below, 1);
  EXPECT_EQ(h.area_above, 12);
  EXPECT_EQ(h.area_without, 16);
  EXPECT_EQ(h.total_area, 31);
  EXPECT_EQ(sum(h), 31);
  EXPECT_EQ(h.critical_area, 14);
  EXPECT_EQ(h.maximum, INFINITY);
  EXPECT_DOUBLE_EQ(h.mean, (-1 + 10 + 400) / 7.0);
}

TEST(histogram, areas_add_up_and_match_a_count_by_hand_for_random_values) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-2, 14);
  std::uniform_int_distribution<int> area(1, 9);  // whole numbers: sums are exact in any order
  std::vector<double> values(5000);
  std::vector<double> areas(5000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(random), areas[i] = area(random);
  const Histogram h = histogram(values, areas, {0, 10}, at_least_4, 25);
  EXPECT_EQ(sum(h), std::accumulate(areas.begin(), areas.end(), 0.0));
  for (const HistogramBin& bin : h.bins) {
    double by_hand = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (bin.from <= values[i] && values[i] < bin.to) by_hand += areas[i];
    }
    EXPECT_EQ(bin.area, by_hand);
  }
}

TEST(histogram, of_nothing_has_no_figures_and_does_not_divide_by_zero) {
  const Histogram h = histogram({}, {}, display_range({}, {}, {}), {});
  EXPECT_FALSE(h.bins.empty());
  EXPECT_TRUE(std::isnan(h.mean) && std::isnan(h.minimum) && std::isnan(h.maximum));
  EXPECT_EQ(h.share(0), 0);
}

TEST(histogram, survives_ranges_without_extent_and_numbers_at_the_end_of_the_world) {
  const std::vector<double> values{1e308, -1e308, 5e-324, 0};
  const std::vector<double> areas{1, 1, 1, 1};
  for (const Limit& limit : {at_least_4, Limit{Limit::Kind::at_least, 1e20, 0}, at_most_4}) {
    for (const DisplayRange& range : {display_range(values, areas, limit), DisplayRange{3, 3},
                                      DisplayRange{-1e308, 1e308}, DisplayRange{0, 5e-324}}) {
      const Histogram h = histogram(values, areas, range, limit);
      EXPECT_EQ(sum(h), 4);
      EXPECT_LE(h.bins.size(), 4096U);
    }
  }
}

TEST(display_range, shows_the_limit_and_95_percent_of_the_area_in_round_numbers) {
  std::vector<double> values(100);
  std::iota(values.begin(), values.end(), 1);
  const std::vector<double> areas(100, 1);
  values.back() = 5000;  // an outlier
  const DisplayRange range = display_range(values, areas, at_least_4);
  EXPECT_EQ(range.low, 0);
  EXPECT_EQ(range.high, 100);
  values.assign(100, 1);
  EXPECT_EQ(display_range(values, areas, at_least_4).high, 6);
}

TEST(areas_of, are_those_of_the_measured_facets_in_their_order) {
  const TriangleMesh mesh = shapes::mesh(shapes::box({0, 0, 0}, {1, 2, 3}));
  Field field;
  field.facets = {0, 11};
  EXPECT_THAT(areas_of(field, mesh), testing::ElementsAre(facet_area(mesh, 0), facet_area(mesh, 11)));
}

}  // namespace
}  // namespace gabarit
