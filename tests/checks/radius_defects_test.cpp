// The radius of meshes that are not what they should be.
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checks/radius.h"
#include "tests/checks/fillets.h"
#include "tests/checks/turning_field.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

TEST(Radius, a_free_edge_is_undecided_never_round) {
  const Field field = measured({{Vec3d{0, 0, 0}, Vec3d{50, 0, 0}, Vec3d{0, 50, 0}}});
  EXPECT_EQ(field.absence[0], Absence::open);
  EXPECT_EQ(field.lower[0], 0);
  EXPECT_EQ(field.upper[0], infinity);
}

TEST(Radius, edges_meet_through_t_junctions) {
  // One facet of the roof's right side is cut in three along the edge.
  auto triangles = roof(pi / 2, 40, 60);
  const Vec3d a = triangles[3][0], v = triangles[3][1], b = triangles[3][2];
  triangles.pop_back();
  const Vec3d m = a + (b - a) * 0.3, n = a + (b - a) * 0.8;
  for (const auto& [p, q] : {std::pair{a, m}, {m, n}, {n, b}}) triangles.push_back({p, v, q});
  const Field field = measured(triangles);
  for (const std::size_t i : {0U, 3U, 4U, 5U}) EXPECT_LT(field.upper[i], 0.4) << i;
}

TEST(Radius, a_facet_that_looks_the_wrong_way_leaves_its_edges_undecided) {
  auto triangles = roof(pi / 2, 40, 60);
  for (const std::size_t i : {2U, 3U}) std::swap(triangles[i][1], triangles[i][2]);
  const Field field = measured(triangles);
  EXPECT_THAT(field.lower, testing::Each(0));
  EXPECT_THAT(field.upper, testing::Each(infinity));
}

TEST(Radius, a_body_that_is_inside_out_never_passes_at_its_edges_and_is_noted) {
  const Field field = measured(shapes::flipped(shapes::box({0, 0, 0}, {30, 20, 10})));
  EXPECT_THAT(field.lower, testing::Each(0));
  EXPECT_THAT(field.notes, testing::ElementsAre(testing::HasSubstr("`part` look inwards")));
}

TEST(Radius, a_sharp_edge_behind_slivers_is_found) {
  // Between the two planes of a roof at metre-size coordinates stands a strip that rounding turns at will.
  const auto planes = shapes::moved(roof(pi / 2, 40, 60), {1000, 1000, 1000});
  auto triangles = planes;
  const double thin = 1e-4;
  for (const std::size_t i : {2U, 3U}) {
    for (Vec3d& p : triangles[i]) p += Vec3d{thin, 0, thin};
  }
  const Vec3d a = planes[0][1], b = planes[0][2], c = triangles[3][0], d = triangles[3][2];
  triangles.push_back({a, c, d});
  triangles.push_back({a, d, b});
  const Field field = measured(triangles);
  EXPECT_LT(field.upper[0], 0.5);
  EXPECT_LT(field.upper[3], 0.5);
  EXPECT_EQ(field.lower[4], 0);
}

TEST(Radius, degenerate_facets_have_no_radius) {
  auto triangles = shapes::box({0, 0, 0}, {10, 10, 10});
  triangles.push_back({Vec3d{0, 0, 0}, Vec3d{5, 0, 0}, Vec3d{10, 0, 0}});
  triangles.push_back({Vec3d{0, 0, 0}, Vec3d{NAN, 0, 0}, Vec3d{10, 0, INFINITY}});
  const Field field = measured(triangles);
  for (const std::size_t i : {12U, 13U}) {
    EXPECT_EQ(field.absence[i], Absence::degenerate);
    EXPECT_TRUE(std::isnan(field.value[i]));
  }
}

}  // namespace
}  // namespace gabarit
