#include "checks/reach_proof.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "checks/reachable_sides.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

using shapes::box;
constexpr double radius = 150;
const Device one = Device::cpu(1);

// A model in plan with the path of a column around it.
struct Plan {
  Model model;
  PlanProjection projection;
  ReachGrid reach;
  DiskPath path;

  explicit Plan(const shapes::Triangles& triangles)
      : model(shapes::model(triangles)),
        projection(model.mesh, Frame{}, Interval{}, one),
        reach(projection, radius, radius, 1e-3, one),
        path(disk_path(outline_features(reachable_sides(projection, reach)), radius, one, &reach)) {}

  std::vector<std::uint8_t> missed() const { return missed_by(path, reach, 0, one); }
};

std::size_t count(const std::vector<std::uint8_t>& facets, std::size_t begin, std::size_t end) {
  return static_cast<std::size_t>(std::count(facets.begin() + static_cast<std::ptrdiff_t>(begin),
                                             facets.begin() + static_cast<std::ptrdiff_t>(end),
                                             std::uint8_t{1}));
}

TEST(ReachProof, a_whole_path_misses_nothing) {
  EXPECT_TRUE(Plan(box({0, 0, 0}, {2000, 800, 300})).missed().empty());
}

TEST(ReachProof, random_boxes_with_mouths_of_all_widths_are_gone_around_whole) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0, 3000), size(1, 900);
  for (int round = 0; round < 8; ++round) {
    shapes::Triangles all;
    for (int i = 0; i < 12; ++i) {
      const Vec3d at{place(random), place(random), 0};
      all = shapes::joined(all, box(at, at + Vec3d{size(random), size(random), 300}));
    }
    EXPECT_TRUE(Plan(all).missed().empty()) << round;
  }
}

TEST(ReachProof, an_outline_that_the_path_leaves_out_is_missed_and_no_other) {
  Plan plan(shapes::joined(box({0, 0, 0}, {800, 800, 300}), box({2000, 0, 0}, {2800, 800, 300})));
  ASSERT_EQ(plan.path.components, 2U);
  std::erase_if(plan.path.pieces, [](const PathPiece& piece) { return piece.from.x > 1400; });
  const std::vector<std::uint8_t> missed = plan.missed();
  ASSERT_EQ(missed.size(), 24U);
  EXPECT_EQ(count(missed, 0, 12), 0U);
  EXPECT_EQ(count(missed, 12, 24), 12U);
}

TEST(ReachProof, one_side_of_a_box_is_missed_with_the_facets_that_it_touches) {
  Plan plan(box({0, 0, 0}, {2000, 800, 300}));
  const std::size_t whole = plan.path.pieces.size();
  std::erase_if(plan.path.pieces,
                [](const PathPiece& p) { return !p.arc && p.from.y > 900 && p.to.y > 900; });
  ASSERT_LT(plan.path.pieces.size(), whole);
  const std::vector<std::uint8_t> missed = plan.missed();
  ASSERT_EQ(missed.size(), 12U);
  EXPECT_GE(count(missed, 0, 12), 2U);
}

TEST(ReachProof, a_yard_that_the_grid_reaches_through_its_mouth_is_missed_without_its_path) {
  const auto walls = shapes::joined(box({0, 0, 0}, {3000, 100, 500}), box({0, 2900, 0}, {3000, 3000, 500}));
  const auto ends = shapes::joined(box({2900, 0, 0}, {3000, 3000, 500}), box({0, 0, 0}, {100, 1200, 500}));
  Plan plan(shapes::joined(shapes::joined(walls, ends), box({0, 1800, 0}, {100, 3000, 500})));
  ASSERT_TRUE(plan.missed().empty());
  std::erase_if(plan.path.pieces, [](const PathPiece& piece) {
    const Point2 middle = (piece.from + piece.to) * 0.5;
    return middle.x > 100 && middle.x < 2900 && middle.y > 100 && middle.y < 2900;
  });
  EXPECT_FALSE(plan.missed().empty());
}

}  // namespace
}  // namespace gabarit
