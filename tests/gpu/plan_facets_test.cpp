#include "gpu/plan_facets.h"

#include <random>

#include <gtest/gtest.h>

#include "gpu/plan_sides.h"
#include "tests/gpu/other_devices.h"

namespace gabarit {
namespace {

using Corners = std::vector<std::array<std::uint32_t, 3>>;
constexpr double infinity = std::numeric_limits<double>::infinity();

const std::vector<Vec3d> corners_of_a_square{{0, 0, 0}, {10, 0, 0}, {10, 10, 20}, {0, 10, 20}};
const Corners two_facets{{0, 1, 2}, {0, 2, 3}};

TEST(PlanFacets, axes_turn_points_to_the_vehicle) {
  const PlanAxes axes{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, 5};  // forward is +y
  const Vec3d at = axes({1, 2, 9});
  EXPECT_EQ(at, (Vec3d{-2, 1, 4}));  // 2 ahead, 1 to the right, 4 above the ground
}

TEST(PlanFacets, the_extent_is_that_of_what_the_band_leaves) {
  for (const Device& device : {Device::cpu(1), Device::simulated(2)}) {
    const PlanFacets whole(device, corners_of_a_square, two_facets, {}, -infinity, infinity);
    EXPECT_EQ(whole.extent().low, (Point2{0, 0}));
    EXPECT_EQ(whole.extent().high, (Point2{10, 10}));
    const PlanFacets lower_half(device, corners_of_a_square, two_facets, {}, 0, 10);
    EXPECT_EQ(lower_half.extent().high, (Point2{10, 5}));
    EXPECT_TRUE(PlanFacets(device, corners_of_a_square, two_facets, {}, 30, 40).extent().empty());
  }
}

TEST(PlanFacets, facets_that_cannot_be_measured_are_counted_and_leave_no_sides) {
  std::vector<Vec3d> points = corners_of_a_square;
  points[3].y = std::nan("");
  points.push_back({2e9, 0, 0});
  const Corners facets{{0, 1, 2}, {0, 2, 3}, {0, 1, 4}};
  for (const Device& device : {Device::cpu(1), Device::simulated(2)}) {
    const PlanFacets plan(device, points, facets, {}, -infinity, infinity);
    EXPECT_EQ(plan.extent().left_out, 2);
    EXPECT_EQ(plan.extent().high, (Point2{10, 10}));
    EXPECT_EQ(plan_sides(plan, std::vector<std::uint32_t>{0, 1, 2}).size(), 3U);
  }
}

TEST(PlanSides, of_a_facet_run_around_it_and_know_where_it_lies) {
  const Device device = Device::simulated(1);
  const PlanFacets plan(device, corners_of_a_square, two_facets, {}, -infinity, infinity);
  const std::vector<PlanSide> sides = plan_sides(plan, std::vector<std::uint32_t>{1, 0});
  ASSERT_EQ(sides.size(), 6U);
  EXPECT_EQ(sides[0].facet, 1U);
  EXPECT_EQ(sides[3].facet, 0U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(sides[i].edge, i % 3);
    EXPECT_EQ(sides[i].to, sides[i / 3 * 3 + (i + 1) % 3].from);
    EXPECT_EQ(sides[i].turn, 1);
  }
}

TEST(PlanSides, where_the_band_cuts_a_facet_a_side_has_no_edge) {
  const PlanFacets plan(Device::cpu(1), corners_of_a_square, two_facets, {}, 0, 10);
  const std::vector<PlanSide> sides = plan_sides(plan, std::vector<std::uint32_t>{0});
  ASSERT_EQ(sides.size(), 4U);
  EXPECT_EQ(std::count_if(sides.begin(), sides.end(), [](const PlanSide& s) { return s.edge == 3; }), 1);
  for (const PlanSide& s : sides) EXPECT_LE(s.from.y, 5);
}

// On a grid of whole numbers the area is exact.
TEST(PlanSides, turns_are_those_of_exact_areas_or_doubtful) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> place(-4, 4);
  std::vector<Vec3d> points;
  Corners facets;
  std::vector<std::uint32_t> all;
  for (std::uint32_t f = 0; f < 3000; ++f) {
    for (int k = 0; k < 3; ++k) points.push_back({double(place(random)), double(place(random)), 0});
    facets.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    all.push_back(f);
  }
  const PlanFacets plan(Device::cpu(1), points, facets, {}, -infinity, infinity);
  const std::vector<PlanSide> sides = plan_sides(plan, all);
  ASSERT_EQ(sides.size(), 9000U);
  for (std::size_t i = 0; i < sides.size(); i += 3) {
    const double area = cross(sides[i].to - sides[i].from, sides[i + 1].to - sides[i].from);
    const int turn = area > 0 ? 1 : area < 0 ? -1 : 0;
    for (std::size_t k = i; k < i + 3; ++k)
      EXPECT_TRUE(sides[k].turn == turn || (turn == 0 && sides[k].turn == doubtful_turn));
  }
}

// Corners that are moved by the last digit: rounding must never turn a facet over.
TEST(PlanSides, a_turn_that_rounding_may_decide_is_doubtful) {
  const Corners facet{{0, 1, 2}};
  int doubtful = 0;
  for (int i = -8; i <= 8; ++i) {
    const double y = 0.3 + i * 1e-17 * 4;
    const std::vector<Vec3d> points{{0.1, 0.1, 0}, {0.3, y, 0}, {24.3, 24.3, 0}};
    const PlanFacets plan(Device::cpu(1), points, facet, {}, -infinity, infinity);
    for (const PlanSide& s : plan_sides(plan, std::vector<std::uint32_t>{0}))
      doubtful += s.turn == doubtful_turn ? 1 : 0;
  }
  EXPECT_GT(doubtful, 0);
}

}  // namespace
}  // namespace gabarit
