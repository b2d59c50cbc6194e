#include "gpu/dexel.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace gabarit {
namespace {

const std::vector<Point2> no_points;
const std::vector<PlanEdge> no_edges;

Dexels offset(const std::vector<Point2>& points, const std::vector<PlanEdge>& edges, const DexelLines& lines,
              double radius, const Device& device = Device::cpu(1)) {
  return offset_dexels(device, points, edges, lines, radius);
}

TEST(Dexel, a_disk_is_crossed_in_its_chords) {
  const Dexels dexels = offset({{10, 0}}, no_edges, {-6, 1, 13}, 5);
  EXPECT_TRUE(dexels.line(0).empty());
  EXPECT_TRUE(dexels.line(1).empty());  // touches the disk, which is open
  ASSERT_EQ(dexels.line(2).size(), 1U);
  EXPECT_EQ(dexels.line(2)[0], (Dexel{7, 13}));  // 3, 4, 5
  EXPECT_EQ(dexels.line(6)[0], (Dexel{5, 15}));
  EXPECT_EQ(dexels.line(10)[0], (Dexel{7, 13}));
}

TEST(Dexel, an_edge_becomes_a_rectangle_to_both_sides) {
  const Dexels flat = offset(no_points, {{{0, 0}, {100, 0}}}, {-3, 1, 7}, 2.5);
  EXPECT_TRUE(flat.line(0).empty());
  for (std::int64_t line = 1; line < 6; ++line) EXPECT_EQ(flat.line(line)[0], (Dexel{0, 100}));
  const Dexels steep = offset(no_points, {{{0, 50}, {0, 0}}}, {25, 1, 1}, 2.5);
  EXPECT_EQ(steep.line(0)[0], (Dexel{-2.5, 2.5}));
  const Dexels slanted = offset(no_points, {{{0, 0}, {30, 40}}}, {20, 1, 1}, 4);
  EXPECT_NEAR(slanted.line(0)[0].from, 15 - 5, 1e-12);
  EXPECT_NEAR(slanted.line(0)[0].to, 15 + 5, 1e-12);
}

TEST(Dexel, disks_unite_where_they_overlap_and_not_where_they_touch) {
  const Dexels apart = offset({{0, 0}, {10, 0}, {19, 0}}, no_edges, {0, 1, 1}, 5);
  ASSERT_EQ(apart.line(0).size(), 2U);
  EXPECT_EQ(apart.line(0)[0], (Dexel{-5, 5}));
  EXPECT_EQ(apart.line(0)[1], (Dexel{5, 24}));
}

TEST(Dexel, a_comb_of_a_thousand_teeth_has_room_on_one_line) {
  std::vector<Point2> teeth;
  for (int i = 0; i < 1000; ++i) teeth.push_back({i * 3.0, 0});
  EXPECT_EQ(offset(teeth, no_edges, {0, 1, 1}, 1).line(0).size(), 1000U);
}

struct Figure {
  std::vector<Point2> points;
  std::vector<PlanEdge> edges;
};

Figure random_figure(std::uint32_t seed) {
  Figure out;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(0, 300), near(-20, 20);
  for (int i = 0; i < 40; ++i) {
    const Point2 p{anywhere(random), anywhere(random)};
    out.points.push_back(p);
    if (i % 2 == 0) continue;
    const Point2 q = p + Point2{near(random), near(random)};
    out.points.push_back(q);
    out.edges.push_back({p, q});
  }
  return out;
}

double distance(const Figure& figure, Point2 p) {
  double least = 1e300;
  for (const Point2 q : figure.points) least = std::min(least, length(p - q));
  for (const auto& [a, b] : figure.edges) {
    const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    least = std::min(least, length(p - (a + (b - a) * t)));
  }
  return least;
}

bool inside(std::span<const Dexel> line, double x) {
  return std::any_of(line.begin(), line.end(), [&](Dexel d) { return d.from < x && x < d.to; });
}

TEST(Dexel, a_place_is_inside_exactly_when_something_is_nearer_than_the_radius) {
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const Figure figure = random_figure(seed);
    const DexelLines lines{-40, 7, 55};
    const Dexels dexels = offset(figure.points, figure.edges, lines, 25);
    for (std::int64_t line = 0; line < lines.count; ++line) {
      for (const Dexel d : dexels.line(line)) {
        EXPECT_NEAR(distance(figure, {d.from, lines.y(line)}), 25, 1e-9);
        EXPECT_NEAR(distance(figure, {d.to, lines.y(line)}), 25, 1e-9);
      }
      for (double x = -40; x < 340; x += 0.37) {
        const double d = distance(figure, {x, lines.y(line)});
        ASSERT_TRUE(inside(dexels.line(line), x) == (d < 25) || std::abs(d - 25) < 1e-9) << x;
      }
    }
  }
}

TEST(Dexel, order_threads_and_vector_instructions_make_no_difference) {
  Figure figure = random_figure(4);
  const DexelLines lines{-40, 0.5, 760};
  const Dexels one = offset(figure.points, figure.edges, lines, 25);
  EXPECT_EQ(one.all, offset(figure.points, figure.edges, lines, 25, Device::cpu(4)).all);
  EXPECT_EQ(
      one.all,
      offset(figure.points, figure.edges, lines, 25, {Device::Kind::cpu, 1, 0, VectorSet::portable}).all);
  std::shuffle(figure.points.begin(), figure.points.end(), std::mt19937(5));
  std::shuffle(figure.edges.begin(), figure.edges.end(), std::mt19937(6));
  const Dexels shuffled = offset(figure.points, figure.edges, lines, 25);
  EXPECT_EQ(one.all, shuffled.all);
  EXPECT_EQ(one.first, shuffled.first);
}

TEST(Dexel, no_lines_and_no_features_are_no_dexels) {
  EXPECT_TRUE(offset(no_points, no_edges, {0, 1, 5}, 1).all.empty());
  EXPECT_TRUE(offset({{0, 0}}, no_edges, {0, 1, 0}, 1).all.empty());
}

}  // namespace
}  // namespace gabarit
