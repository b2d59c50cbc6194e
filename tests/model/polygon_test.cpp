#include "model/polygon.h"

#include <numbers>
#include <random>

#include <gmock/gmock.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

using Corners = std::vector<std::array<std::size_t, 3>>;

Vec3d area_of(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return cross(b - a, c - a) / 2; }

Vec3d area_of(const std::vector<Vec3d>& polygon) {
  Vec3d sum;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += area_of(polygon[0], polygon[i], polygon[i + 1]);
  return sum;
}

// The triangles cover a simple polygon just once when none is turned over and their areas add up to its area.
void expect_covered(const std::vector<Vec3d>& polygon) {
  const Corners triangles = triangulate(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  const Vec3d whole = area_of(polygon);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec3d area = area_of(polygon[a], polygon[b], polygon[c]);
    EXPECT_GE(dot(area, whole), -1e-9 * squared_length(whole));
    sum += length(area);
  }
  EXPECT_NEAR(sum, length(whole), 1e-9 * length(whole));
}

std::vector<Vec3d> turned(std::vector<Vec3d> polygon, const Vec3d& axis, double angle) {
  for (Vec3d& p : polygon) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    p = p * c + cross(axis, p) * s + axis * (dot(axis, p) * (1 - c)) + Vec3d{1000, -200, 30};
  }
  return polygon;
}

// Angles ascend and radii jump: simple, and as jagged as can be.
std::vector<Vec3d> random_star(std::uint32_t seed, std::size_t corners) {
  std::mt19937 random(seed);
  std::vector<Vec3d> polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    const double radius = 1 + static_cast<double>(random() % 1000) / 100;
    polygon.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return polygon;
}

TEST(polygon, fewer_than_three_corners_give_nothing_and_three_give_themselves) {
  EXPECT_TRUE(triangulate(std::vector<Vec3d>{}).empty());
  EXPECT_TRUE(triangulate(std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}}).empty());
  EXPECT_EQ(triangulate(std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Corners{{0, 1, 2}}));
}

TEST(polygon, a_convex_one_becomes_the_fan_around_its_first_corner) {
  EXPECT_EQ(triangulate(std::vector<Vec3d>{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}}),
            (Corners{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(polygon, a_concave_one_is_covered_once) {
  expect_covered({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}});
  expect_covered({{0, 0, 0}, {0, 4, 0}, {2, 1, 0}, {4, 4, 0}, {4, 0, 0}});
}

TEST(polygon, corners_on_a_straight_side_are_used) {
  expect_covered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}});
}

TEST(polygon, a_hole_reached_by_a_cut_stays_a_hole) {
  expect_covered({{0, 0, 0},
                  {9, 0, 0},
                  {9, 9, 0},
                  {0, 9, 0},
                  {0, 0, 0},
                  {3, 3, 0},
                  {3, 6, 0},
                  {6, 6, 0},
                  {6, 3, 0},
                  {3, 3, 0}});
}

TEST(polygon, random_simple_ones_are_covered_once_in_any_plane) {
  std::mt19937 random(11);
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    const std::vector<Vec3d> polygon = random_star(seed, 4 + seed);
    expect_covered(polygon);
    const Vec3d axis =
        normalized(Vec3d{static_cast<double>(random() % 9) + 1, static_cast<double>(random() % 9), 3});
    expect_covered(turned(polygon, axis, static_cast<double>(seed)));
    std::vector<Vec3d> other_start = polygon;
    std::rotate(other_start.begin(), other_start.begin() + seed % 4, other_start.end());
    expect_covered(other_start);
    std::reverse(other_start.begin(), other_start.end());
    expect_covered(other_start);
  }
}

TEST(polygon, one_that_crosses_itself_still_gives_n_minus_2) {
  EXPECT_EQ(triangulate(std::vector<Vec3d>{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}).size(), 2U);
  std::mt19937 random(13);
  for (std::size_t n = 4; n < 60; ++n) {
    std::vector<Vec3d> polygon;
    for (std::size_t i = 0; i < n; ++i)
      polygon.push_back({static_cast<double>(random() % 5), static_cast<double>(random() % 5),
                         static_cast<double>(random() % 5)});
    const Corners triangles = triangulate(polygon);
    EXPECT_EQ(triangles.size(), n - 2);
    // Every corner is in one of them.
    std::vector<bool> used(n);
    for (const auto& t : triangles) {
      for (const std::size_t corner : t) used[corner] = true;
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), true), static_cast<std::ptrdiff_t>(n));
  }
}

TEST(polygon, without_area_or_finite_corners_still_gives_n_minus_2) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(triangulate(std::vector<Vec3d>(7, Vec3d{1, 1, 1})).size(), 5U);
  EXPECT_EQ(triangulate(std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).size(), 2U);
  EXPECT_EQ(triangulate(std::vector<Vec3d>{{0, 0, 0}, {nan, 0, 0}, {2, 0, 0}, {3, 1, 0}}).size(), 2U);
}

}  // namespace
}  // namespace gabarit
