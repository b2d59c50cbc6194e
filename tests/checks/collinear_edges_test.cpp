#include "checks/collinear_edges.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "gpu/segment2.h"

namespace gabarit {
namespace {

struct Edge {
  Point2 from, to;
  int area;
};

OutlineFeatures outline_of(const std::vector<Edge>& edges) {
  OutlineFeatures out;
  for (const Edge& e : edges) {
    const auto n = static_cast<std::uint32_t>(out.points.size());
    out.points.push_back(e.from);
    out.points.push_back(e.to);
    out.edges.emplace_back(n, n + 1);
    out.area.push_back(static_cast<std::int8_t>(e.area));
  }
  return out;
}

Edge edge_of(const OutlineFeatures& outline, std::size_t i) {
  return {outline.points[outline.edges[i].first], outline.points[outline.edges[i].second], outline.area[i]};
}

TEST(CollinearEdges, the_rows_of_a_wall_become_one_edge) {
  const auto wall =
      join_collinear(outline_of({{{0, 5}, {4, 5}, 0}, {{9, 5}, {3, 5}, 0}, {{9, 5}, {12, 5}, 0}}));
  ASSERT_EQ(wall.edges.size(), 1U);
  EXPECT_EQ(wall.points.size(), 2U);
  EXPECT_TRUE(edge_of(wall, 0).from == (Point2{0, 5}));
  EXPECT_TRUE(edge_of(wall, 0).to == (Point2{12, 5}));
}

TEST(CollinearEdges, an_upright_wall_is_joined_as_well) {
  const auto wall = join_collinear(outline_of({{{5, 0}, {5, 4}, 0}, {{5, 2}, {5, 8}, 0}}));
  ASSERT_EQ(wall.edges.size(), 1U);
  EXPECT_TRUE(edge_of(wall, 0).to == (Point2{5, 8}));
}

TEST(CollinearEdges, an_edge_that_runs_the_other_way_has_its_area_on_the_other_hand) {
  const auto same = join_collinear(outline_of({{{0, 0}, {4, 0}, 1}, {{6, 0}, {3, 0}, -1}}));
  ASSERT_EQ(same.edges.size(), 1U);
  EXPECT_EQ(same.area[0], 1);
  EXPECT_EQ(join_collinear(outline_of({{{0, 0}, {4, 0}, 1}, {{6, 0}, {3, 0}, 1}})).edges.size(), 2U);
}

TEST(CollinearEdges, gaps_other_lines_and_other_directions_keep_edges_apart) {
  const auto outline = outline_of({{{0, 0}, {4, 0}, 0},
                                   {{4.5, 0}, {6, 0}, 0},
                                   {{0, 1e-9}, {4, 1e-9}, 0},
                                   {{0, 0}, {4, 4}, 0},
                                   {{2, 2}, {6, 6}, 0}});
  EXPECT_EQ(join_collinear(outline).edges.size(), 5U);
}

TEST(CollinearEdges, points_of_no_edge_and_points_of_other_edges_stay) {
  auto outline = outline_of({{{0, 0}, {4, 0}, 0}, {{4, 0}, {6, 0}, 0}});
  outline.points.push_back({1, 7});
  outline.points.push_back({4, 3});
  outline.edges.emplace_back(1, 5);  // from the point where the two meet
  outline.area.push_back(0);
  const auto joined = join_collinear(outline);
  EXPECT_EQ(joined.edges.size(), 2U);
  EXPECT_EQ(joined.points.size(), 5U);
}

double distance(const OutlineFeatures& outline, Point2 p) {
  double least = 1e300;
  for (const Point2 q : outline.points) least = std::min(least, length(p - q));
  for (const auto& [a, b] : outline.edges)
    least = std::min(least, point_segment_distance(p, outline.points[a], outline.points[b]));
  return least;
}

TEST(CollinearEdges, the_outline_stays_the_same_set_of_places_in_any_order) {
  std::mt19937 random(3);
  const auto number = [&](unsigned n) { return static_cast<double>(random() % n); };
  for (int round = 0; round < 50; ++round) {
    std::vector<Edge> edges;
    for (int i = 0; i < 30; ++i) {
      const Point2 a{number(6), number(6)};
      const Point2 b =
          random() % 2 == 0 ? Point2{a.x + 1 + number(3), a.y} : Point2{a.x, a.y + 1 + number(3)};
      edges.push_back({a, b, static_cast<int>(random() % 3) - 1});
    }
    const auto before = outline_of(edges);
    const auto after = join_collinear(before);
    EXPECT_LE(after.edges.size(), before.edges.size());
    for (double x = -1; x < 10; x += 0.37) {
      for (double y = -1; y < 10; y += 0.41)
        ASSERT_NEAR(distance(after, {x, y}), distance(before, {x, y}), 1e-12);
    }
    std::shuffle(edges.begin(), edges.end(), random);
    EXPECT_EQ(join_collinear(outline_of(edges)).edges.size(), after.edges.size());
  }
}

}  // namespace
}  // namespace gabarit
