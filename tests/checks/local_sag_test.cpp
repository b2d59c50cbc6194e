#include "checks/local_sag.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "model/facet_normals.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

using shapes::Triangles;

constexpr double crease = 40 * std::numbers::pi / 180;

std::vector<float> sag_of(const Triangles& shape, double declared = 10) {
  const TriangleMesh mesh = shapes::mesh(shape);
  return local_sag(mesh, facet_normals(mesh, Device::cpu()), Adjacency(mesh), crease, declared,
                   Device::cpu());
}

// How far the surface lies from places of a facet, `off` being the distance of a point from it.
double greatest_gap(const shapes::Triangle& t, double (*off)(const Vec3d&)) {
  double most = 0;
  constexpr int steps = 12;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const double v = static_cast<double>(i) / steps, w = static_cast<double>(j) / steps;
      most = std::max(most, std::fabs(off(t[0] + v * (t[1] - t[0]) + w * (t[2] - t[0]))));
    }
  }
  return most;
}

// Holds the surface everywhere, without being many times too wide.
void expect_held(const Triangles& shape, double (*off)(const Vec3d&), double most_times) {
  const std::vector<float> sag = sag_of(shape);
  for (std::size_t f = 0; f < shape.size(); ++f) {
    const double gap = greatest_gap(shape[f], off), s = static_cast<double>(sag[f]);
    ASSERT_GE(s, gap * (1 - 1e-4)) << "facet " << f;
    ASSERT_LE(s, most_times * gap + 1e-6) << "facet " << f;
  }
}

double off_ball(const Vec3d& p) { return length(p) - 10; }
double off_rod(const Vec3d& p) {
  const bool end = p.z < 1e-9 || p.z > 20 - 1e-9;
  return end ? 0 : std::hypot(p.x, p.y) - 5;
}
double off_torus(const Vec3d& p) { return std::hypot(std::hypot(p.x, p.y) - 30, p.z) - 4; }

TEST(LocalSag, holds_the_surface_of_tessellated_balls) {
  for (const auto& [rings, segments] : {std::pair{12, 20}, {40, 80}, {20, 12}})
    expect_held(shapes::sphere(10, rings, segments), off_ball, 8);
}

TEST(LocalSag, holds_the_surface_of_tessellated_rods) {
  for (const int segments : {12, 24, 72})
    for (const double z : {20.0})
      expect_held(shapes::revolve({{0, 0}, {5, 0}, {5, z}, {0, z}}, segments), off_rod, 2.5);
}

TEST(LocalSag, holds_the_surface_of_tessellated_tori) {
  for (const auto& [around, tube] : {std::pair{24, 12}, {120, 40}, {40, 60}})
    expect_held(shapes::torus(30, 4, around, tube), off_torus, 12);
}

TEST(LocalSag, is_nothing_on_flat_walls_and_across_sharp_edges) {
  for (const auto& shape :
       {shapes::gridded_box({0, 0, 0}, {9, 7, 5}, 1),
        shapes::rotated(shapes::box({0, 0, 0}, {9, 7, 5}), normalized(Vec3d{1, 2, 3}), 1)})
    for (const float s : sag_of(shape)) EXPECT_EQ(s, 0);
}

TEST(LocalSag, is_never_more_than_declared) {
  for (const float s : sag_of(shapes::sphere(10, 8, 12), 0.03)) EXPECT_LE(s, 0.03F);
}

TEST(LocalSag, moved_turned_and_permuted_it_stays_the_same) {
  const Triangles shape = shapes::torus(30, 4, 24, 12);
  const std::vector<float> as_is = sag_of(shape);
  const std::vector<float> moved =
      sag_of(shapes::moved(shapes::rotated(shape, normalized(Vec3d{1, 2, 3}), 0.7), Vec3d{500, -300, 20}));
  std::vector<std::uint32_t> order;
  const std::vector<float> mixed = sag_of(shapes::permuted(shape, 3, &order));
  for (std::size_t f = 0; f < shape.size(); ++f) {
    EXPECT_NEAR(moved[f], as_is[f], 1e-5F);
    EXPECT_NEAR(mixed[f], as_is[order[f]], 1e-6F);
  }
}

TEST(LocalSag, of_a_fillet_does_not_spread_over_the_plane_that_it_leaves) {
  std::vector<shapes::Point2> profile = shapes::arc({9, 9}, 1, 0, std::numbers::pi / 2, 6);
  profile.insert(profile.begin(), {{0, 0}, {10, 0}});
  profile.push_back({0, 10});
  const Triangles shape = shapes::extrude(profile, 0, 30);
  const std::vector<float> sag = sag_of(shape);
  const double chord = 1 - std::cos(std::numbers::pi / 24);  // of a strip of the fillet
  for (std::size_t f = 0; f < shape.size(); ++f) EXPECT_LE(sag[f], 6 * chord) << f;
}

}  // namespace
}  // namespace gabarit
