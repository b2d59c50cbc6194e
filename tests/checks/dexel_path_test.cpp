#include "checks/dexel_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "checks/contact_depth.h"

namespace gabarit {
namespace {

using Sides = std::vector<PlanSide>;

void add_side(Sides& sides, Point2 a, Point2 b) {
  sides.push_back({a, b, static_cast<FacetId>(sides.size()), 0, 0});
}

std::vector<Point2> places(const Sides& sides, double radius, double spacing, int threads = 1) {
  std::vector<Point2> out;
  const DiskPath path = dexel_path(outline_features(sides), radius, spacing, Device::cpu(threads));
  for (const PathPiece& piece : path.pieces) out.push_back(piece.from);
  return out;
}

double distance(const Sides& sides, Point2 p) {
  double least = 1e300;
  for (const PlanSide& s : sides) least = std::min(least, point_segment_distance(p, s.from, s.to));
  return least;
}

// Whether any place lies nearer than 2 mm more than the radius to the middle of the last side.
bool reaches_last(const Sides& sides, double radius, double spacing) {
  const Point2 target = (sides.back().from + sides.back().to) * 0.5;
  const auto all = places(sides, radius, spacing);
  return std::any_of(all.begin(), all.end(), [&](Point2 p) { return length(p - target) < radius + 2; });
}

TEST(DexelPath, the_path_around_a_point_is_a_circle) {
  Sides sides;
  add_side(sides, {3, 4}, {3, 4});
  const auto all = places(sides, 150, 0.98);
  for (const Point2 p : all) ASSERT_NEAR(length(p - Point2{3, 4}), 150, 1e-9);
  // Four ends a line and its mirror image, in both directions.
  EXPECT_NEAR(static_cast<double>(all.size()), 4 * 300 / 0.98, 4);
}

// A room between thick walls with a plate in it, open to one side and turned about the origin.
Sides pocket(double mouth, double turn) {
  Sides sides;
  const auto at = [&](double x, double y) {
    return Point2{x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn)};
  };
  const double h = mouth / 2;
  add_side(sides, at(0, h), at(800, h));
  add_side(sides, at(0, -h), at(800, -h));
  add_side(sides, at(0, h), at(0, h + 300));
  add_side(sides, at(0, -h), at(0, -h - 300));
  add_side(sides, at(0, h + 300), at(800, h + 300));
  add_side(sides, at(0, -h - 300), at(800, -h - 300));
  add_side(sides, at(800, -h - 300), at(800, h + 300));
  add_side(sides, at(500, -20), at(500, 20));
  return sides;
}

TEST(DexelPath, a_mouth_of_the_diameter_is_open_whichever_way_it_points) {
  for (int i = 0; i < 12; ++i) EXPECT_TRUE(reaches_last(pocket(300.001, i * 0.3), 150, 0.98)) << i;
}

TEST(DexelPath, a_mouth_that_is_too_narrow_by_a_diagonal_is_closed_whichever_way_it_points) {
  for (int i = 0; i < 12; ++i) EXPECT_FALSE(reaches_last(pocket(300 - 1.4, i * 0.3), 150, 0.98)) << i;
}

TEST(DexelPath, a_hole_is_never_reached_whatever_its_size) {
  Sides sides;
  constexpr int n = 90;
  const auto at = [](double r, int i) {
    return Point2{r * std::cos(2 * std::numbers::pi * i / n), r * std::sin(2 * std::numbers::pi * i / n)};
  };
  for (int i = 0; i < n; ++i) add_side(sides, at(400, i), at(400, i + 1));
  add_side(sides, {-5, 0}, {5, 0});
  EXPECT_FALSE(reaches_last(sides, 150, 0.98));
  for (const Point2 p : places(sides, 150, 0.98)) ASSERT_GT(length(p), 400);
}

TEST(DexelPath, nothing_has_no_path_and_a_model_too_long_for_its_lines_is_refused) {
  EXPECT_TRUE(places({}, 150, 1).empty());
  Sides sides;
  add_side(sides, {0, 0}, {1e9, 0});
  EXPECT_THROW(places(sides, 150, 1), std::invalid_argument);
}

Sides random_sides(std::mt19937& random) {
  std::uniform_real_distribution<double> place(0, 12);
  Sides sides;
  for (int i = 0; i < 8; ++i) add_side(sides, {place(random), place(random)}, {place(random), place(random)});
  return sides;
}

class RandomOutlines : public testing::TestWithParam<double> {};

TEST_P(RandomOutlines, from_every_place_of_the_path_one_is_known_within_a_diagonal) {
  std::mt19937 random(11);
  for (int round = 0; round < 40; ++round) {
    const Sides sides = random_sides(random);
    const double radius = 1.5;
    const auto known = places(sides, radius, GetParam());
    const auto expect_near = [&](Point2 p) {
      double least = 1e300;
      for (const Point2 q : known) least = std::min(least, length(p - q));
      ASSERT_LE(least, GetParam() * std::numbers::sqrt2 + 1e-9) << "round " << round;
    };
    for (const PathPiece& piece : disk_path(outline_features(sides), radius, Device::cpu(1)).pieces) {
      for (int i = 0; i <= 20; ++i) {
        const double angle = piece.from_angle + (piece.to_angle - piece.from_angle) * i / 20;
        expect_near(piece.arc ? piece.centre + Point2{std::cos(angle), std::sin(angle)} * radius
                              : piece.from + (piece.to - piece.from) * (i / 20.0));
      }
    }
  }
}

TEST_P(RandomOutlines, every_place_touches_and_a_slightly_smaller_disk_gets_there) {
  std::mt19937 random(12);
  for (int round = 0; round < 40; ++round) {
    const Sides sides = random_sides(random);
    const double radius = 1.5;
    for (const Point2 p : places(sides, radius, GetParam())) ASSERT_NEAR(distance(sides, p), radius, 1e-9);
    const OutlineFeatures outline = outline_features(sides);
    const double smaller = radius - GetParam() / std::numbers::sqrt2;
    const ContactDepth contact(sides, radius, Device::cpu(1));
    const Device one = Device::cpu(1);
    const auto found = contact.along(dexel_path(outline, radius, GetParam(), one), 1e-6);
    const auto truth = contact.along(disk_path(outline, smaller, one), 1e-5);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      EXPECT_TRUE(found[i] > 1e-6F || truth[i] <= 1e-5F) << "round " << round << ", side " << i;
    }
  }
}

// Exactly along the path, against what the places alone can vouch for.
TEST_P(RandomOutlines, nothing_that_the_path_touches_is_out_of_reach_of_its_known_places) {
  std::mt19937 random(14);
  const Device one = Device::cpu(1);
  for (int round = 0; round < 60; ++round) {
    const Sides sides = random_sides(random);
    const OutlineFeatures outline = outline_features(sides);
    const ContactDepth contact(sides, 1.5, one);
    const double apart = GetParam() * std::numbers::sqrt2;
    for (const double tolerance : {1e-3, 0.1}) {
      const auto found = contact.along(dexel_path(outline, 1.5, GetParam(), one), tolerance, apart);
      const auto truth = contact.along(disk_path(outline, 1.5, one), tolerance - 1e-6);
      for (std::size_t i = 0; i < sides.size(); ++i)
        EXPECT_TRUE(std::isinf(truth[i]) || std::isfinite(found[i])) << "round " << round << ", side " << i;
    }
  }
}

TEST(DexelPath, half_a_spacing_behind_a_straight_front_nothing_is_in_reach) {
  Sides sides;
  add_side(sides, {0, 0}, {1000, 0});
  add_side(sides, {0, 500}, {1000, 500});
  add_side(sides, {0, 0}, {0, 500});
  add_side(sides, {1000, 0}, {1000, 500});
  add_side(sides, {400, 0.5}, {410, 0.5});
  const Device one = Device::cpu(1);
  const DiskPath path = dexel_path(outline_features(sides), 150, 0.98, one);
  const auto depth = ContactDepth(sides, 150, one).along(path, 0.1, 0.98 * std::numbers::sqrt2);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(std::isfinite(depth[i])) << i;
  EXPECT_TRUE(std::isinf(depth[4]));
}

TEST(DexelPath, contours_of_a_point_and_of_two_islands_are_closed_lines_through_all_places) {
  Sides sides;
  add_side(sides, {3, 4}, {3, 4});
  add_side(sides, {1000, 4}, {1040, 80});
  const DiskPath path = dexel_path(outline_features(sides), 150, 0.98, Device::cpu(1));
  ASSERT_EQ(path.contours.size(), 2U);
  std::size_t points = 0;
  for (const Contour& contour : path.contours) {
    EXPECT_TRUE(contour.closed);
    for (std::size_t i = 1; i < contour.points.size(); ++i)
      ASSERT_LE(length(contour.points[i] - contour.points[i - 1]), 0.98 * std::numbers::sqrt2 + 1e-9);
    points += contour.points.size() - 1;
  }
  EXPECT_EQ(points, path.pieces.size());
}

INSTANTIATE_TEST_SUITE_P(Spacings, RandomOutlines, testing::Values(0.05, 0.2, 0.7));

TEST(DexelPath, shuffling_and_threads_make_no_difference) {
  std::mt19937 random(13);
  Sides sides = random_sides(random);
  const auto expected = places(sides, 1.5, 0.1);
  EXPECT_EQ(places(sides, 1.5, 0.1, 4), expected);
  std::shuffle(sides.begin(), sides.end(), random);
  EXPECT_EQ(places(sides, 1.5, 0.1), expected);
}

}  // namespace
}  // namespace gabarit
