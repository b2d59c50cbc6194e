#include "checks/disk_path.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "checks/certified.h"
#include "checks/contact_depth.h"
#include "tests/checks/disk_path_reference.h"

namespace gabarit {
namespace {

using Sides = std::vector<PlanSide>;
constexpr double tolerance = 1e-3;

void add_side(Sides& sides, Point2 a, Point2 b, int turn = 0) {
  sides.push_back({a, b, static_cast<FacetId>(sides.size()), 0, turn});
}

// The outline of a closed polygon, counter-clockwise.
void add_polygon(Sides& sides, const std::vector<Point2>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    add_side(sides, corners[i], corners[(i + 1) % corners.size()], 1);
}

std::vector<bool> touched(const Sides& sides, double radius, int threads = 1) {
  const DiskPath path = disk_path(outline_features(sides), radius, Device::cpu(threads));
  std::vector<bool> out;
  for (const float depth : ContactDepth(sides, radius, Device::cpu(threads)).along(path, tolerance))
    out.push_back(depth <= tolerance);
  return out;
}

TEST(DiskPath, a_box_is_touched_all_around) {
  Sides sides;
  add_polygon(sides, {{0, 0}, {2000, 0}, {2000, 800}, {0, 800}});
  EXPECT_EQ(touched(sides, 150), std::vector<bool>(4, true));
}

TEST(DiskPath, the_path_around_a_point_is_a_circle) {
  Sides sides;
  add_side(sides, {3, 4}, {3, 4});
  const DiskPath path = disk_path(outline_features(sides), 10, Device::cpu(1));
  ASSERT_EQ(path.pieces.size(), 1U);
  EXPECT_DOUBLE_EQ(path.pieces[0].to_angle - path.pieces[0].from_angle, 2 * std::numbers::pi);
  EXPECT_EQ(path.components, 1U);
}

// A yard between two long walls, open to -x; the last side is its rear wall, set back from the walls' rear
// ends.
Sides yard(double mouth, double depth) {
  Sides sides;
  const double h = mouth / 2;
  add_polygon(sides, {{0, h}, {depth, h}, {depth, h + 100}, {0, h + 100}});
  add_polygon(sides, {{0, -h - 100}, {depth, -h - 100}, {depth, -h}, {0, -h}});
  add_side(sides, {depth / 2, -h}, {depth / 2, h});
  return sides;
}

TEST(DiskPath, a_mouth_of_the_diameter_opens_a_pocket_and_a_micrometre_less_closes_it) {
  EXPECT_TRUE(touched(yard(300.0, 1000), 150).back());
  EXPECT_TRUE(touched(yard(300.000001, 1000), 150).back());
  EXPECT_FALSE(touched(yard(299.999999, 1000), 150).back());
}

TEST(DiskPath, the_disk_does_not_pass_the_floor_of_a_deep_pocket) {
  Sides sides = yard(301, 10000);
  add_side(sides, {5200, -10}, {5200, 10});  // behind the floor, in a room closed at its rear
  add_side(sides, {10000, -150.5}, {10000, 150.5});
  const auto touch = touched(sides, 150);
  EXPECT_TRUE(touch[8]);
  EXPECT_FALSE(touch[9]);
}

TEST(DiskPath, a_round_hole_is_never_touched_whatever_its_size) {
  Sides sides;
  constexpr int n = 90;
  const auto at = [](double r, int i) {
    return Point2{r * std::cos(2 * std::numbers::pi * i / n), r * std::sin(2 * std::numbers::pi * i / n)};
  };
  for (int i = 0; i < n; ++i) add_side(sides, at(900, i), at(900, i + 1));
  for (int i = 0; i < n; ++i) add_side(sides, at(400, i), at(400, i + 1));
  add_side(sides, {-5, 0}, {5, 0});  // an island in the hole
  const auto touch = touched(sides, 150);
  EXPECT_EQ(std::count(touch.begin(), touch.begin() + n, true), n);
  EXPECT_EQ(std::count(touch.begin() + n, touch.end(), true), 0);
}

TEST(DiskPath, an_island_in_an_open_yard_is_reached) {
  Sides sides = yard(2000, 3000);
  add_side(sides, {1500, -20}, {1500, 20});
  EXPECT_TRUE(touched(sides, 150).back());
}

TEST(DiskPath, parts_far_apart_are_all_reached) {
  Sides sides;
  for (int i = 0; i < 5; ++i)
    add_polygon(sides, {{1000.0 * i, 0}, {1000.0 * i + 10, 0}, {1000.0 * i + 10, 10}, {1000.0 * i, 10}});
  EXPECT_EQ(touched(sides, 150), std::vector<bool>(20, true));
  EXPECT_EQ(disk_path(outline_features(sides), 150, Device::cpu(1)).components, 5U);
}

// The plan view of an upright flat face: a fan of needles along one line, apart by the rounding of
// coordinates.
Sides upright_fan(double angle) {
  const auto at = [&](double t) { return Point2{1668.9 + t * std::cos(angle), 153.7 + t * std::sin(angle)}; };
  Sides sides;
  constexpr int n = 24;
  for (int i = 0; i < n; ++i) {
    const double turn = 2 * std::numbers::pi / n;
    const Point2 needle[3] = {at(0), at(34 * std::cos(turn * i)), at(34 * std::cos(turn * (i + 1)))};
    for (int k = 0; k < 3; ++k) {
      const Point2 a = needle[k], b = needle[(k + 1) % 3];
      add_side(sides, a, b, side_of_line(a, b, needle[(k + 2) % 3]));
    }
  }
  return sides;
}

TEST(DiskPath, sides_that_differ_by_rounding_only_leave_no_gap_in_the_path) {
  for (int k = 0; k < 40; ++k) {
    const DiskPath path = disk_path(outline_features(upright_fan(0.02 + 0.07 * k)), 150, Device::cpu(1));
    EXPECT_EQ(path.components, 1U) << k;
  }
}

TEST(DiskPath, overlapping_collinear_sides_and_tees_do_not_hide_each_other) {
  Sides sides;
  add_side(sides, {0, 0}, {100, 0});
  add_side(sides, {50, 0}, {150, 0});
  add_side(sides, {150, 0}, {0, 0});
  add_side(sides, {50, 0}, {50, 0});
  add_side(sides, {30, 0}, {30, 0.5});
  EXPECT_EQ(touched(sides, 20), std::vector<bool>(5, true));
}

TEST(DiskPath, a_path_along_sides_that_overlap_without_sharing_ends_hangs_together) {
  Sides cross;
  add_side(cross, {20, 20}, {4, 20});
  add_side(cross, {0, 20}, {5, 20});
  add_side(cross, {3, 17}, {3, 23});
  EXPECT_EQ(touched(cross, 0.5), std::vector<bool>(3, true));
  EXPECT_EQ(disk_path(outline_features(cross), 0.5, Device::cpu(1)).components, 1U);
  Sides corner;
  add_side(corner, {1, 10}, {0, 10});
  add_side(corner, {2, 13}, {9, 13});
  add_side(corner, {0, 6}, {0, 13});
  add_side(corner, {0, 13}, {8, 13});
  add_side(corner, {0, 0}, {0, 7});
  add_side(corner, {0, 7}, {3, 7});
  const auto touch = touched(corner, 5);
  EXPECT_TRUE(std::all_of(touch.begin() + 1, touch.end(), [](bool t) { return t; }));
}

TEST(DiskPath, a_closed_room_as_wide_as_the_disk_is_not_reached) {
  // Between two walls the disk has room to move by a sixth of a millimetre, and no way in.
  Sides sides;
  add_side(sides, {9, 9}, {9, 9});
  add_side(sides, {12, 8}, {18, 8});
  add_side(sides, {8, 13}, {8, 5});
  add_side(sides, {11, 7}, {5, 7});
  add_side(sides, {13, 10}, {0, 10});
  EXPECT_EQ(touched(sides, 1.5), (std::vector<bool>{false, true, true, true, true}));
}

TEST(DiskPath, an_edge_inside_the_projection_is_dropped) {
  Sides sides;
  add_polygon(sides, {{0, 0}, {10, 0}, {10, 10}});
  add_polygon(sides, {{0, 0}, {10, 10}, {0, 10}});
  const OutlineFeatures outline = outline_features(sides);
  EXPECT_EQ(outline.points.size(), 4U);
  EXPECT_EQ(outline.edges.size(), 4U);
}

// Small whole numbers make every tie there is: coincident, collinear and crossing sides, gaps of exactly the
// diameter.
class RandomOutline : public testing::TestWithParam<double> {};

TEST_P(RandomOutline, touches_what_brute_force_touches) {
  const double radius = GetParam();
  std::mt19937 random(7);
  const auto number = [&](int n) { return static_cast<double>(random() % static_cast<unsigned>(n)); };
  int compared = 0;
  for (int round = 0; round < 400 && compared < 60; ++round) {
    Sides sides;
    const int shapes = 2 + static_cast<int>(random() % 5);
    for (int i = 0; i < shapes; ++i) {
      const Point2 a{number(13), number(13)};
      const Point2 b = random() % 8 == 0 ? a : Point2{number(13), number(13)};
      add_side(sides, a, b);
      if (random() % 3 == 0) add_side(sides, b, {number(13), number(13)});
    }
    const reference::Contacts expected = reference::contacts(sides, radius, tolerance);
    if (expected.near_tie) continue;
    ++compared;
    const auto found = touched(sides, radius);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      EXPECT_TRUE(found[i] || !expected.surely[i]) << "round " << round << ", side " << i << " is missed";
      EXPECT_TRUE(!found[i] || expected.possibly[i])
          << "round " << round << ", side " << i << " is out of reach";
    }
  }
  EXPECT_GE(compared, 20);
}

INSTANTIATE_TEST_SUITE_P(Radii, RandomOutline, testing::Values(1.0, 2.5, 1.3, 5.0));

TEST(DiskPath, moving_and_turning_the_outline_changes_nothing) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 12);
  for (int round = 0; round < 30; ++round) {
    Sides sides;
    for (int i = 0; i < 8; ++i)
      add_side(sides, {place(random), place(random)}, {place(random), place(random)});
    Sides turned = sides;
    const double a = place(random);
    for (PlanSide& s : turned) {
      for (Point2* p : {&s.from, &s.to})
        *p = {p->x * std::cos(a) - p->y * std::sin(a) + 1000, p->x * std::sin(a) + p->y * std::cos(a) - 2000};
    }
    std::swap(turned.front(), turned.back());
    std::vector<bool> expected = touched(sides, 1.5);
    std::vector<bool>::swap(expected.front(), expected.back());
    EXPECT_EQ(touched(turned, 1.5), expected) << "round " << round;
  }
}

TEST(DiskPath, the_number_of_threads_changes_nothing) {
  Sides sides;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 200);
  for (int i = 0; i < 200; ++i) {
    const Point2 p{place(random), place(random)};
    add_side(sides, p, p + Point2{place(random) / 50, place(random) / 50});
  }
  const OutlineFeatures outline = outline_features(sides);
  const DiskPath one = disk_path(outline, 5, Device::cpu(1));
  const DiskPath two = disk_path(outline, 5, Device::cpu(2));
  ASSERT_EQ(one.pieces.size(), two.pieces.size());
  for (std::size_t i = 0; i < one.pieces.size(); ++i) EXPECT_TRUE(one.pieces[i].from == two.pieces[i].from);
}

}  // namespace
}  // namespace gabarit
