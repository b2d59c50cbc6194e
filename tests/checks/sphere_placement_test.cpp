#include "checks/sphere_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "gpu/triangle.h"
#include "tests/checks/fillets.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Field placed(const shapes::Triangles& triangles) {
  const Model model = shapes::model(triangles);
  return measure_sphere_placement(Scene(model, Device::cpu(1)), Setup{}, whole_model(model.mesh));
}

// By bisection over balls, against every facet that shares a corner pair: no adjacency, no closed form.
double largest_ball(const TriangleMesh& mesh, FacetId f) {
  const auto fits = [&](double radius) {
    const Vec3d centre = mesh.centroid(f) - radius * facet_normal(mesh, f);
    for (FacetId g = 0; g < mesh.facet_count(); ++g) {
      int shared = 0;
      for (const VertexId v : mesh.facets[f]) {
        for (const VertexId w : mesh.facets[g]) shared += v == w;
      }
      if (shared != 2) continue;
      const auto [a, b, c] = mesh.corners(g);
      if (length(closest_point(centre, a, b, c) - centre) < radius) return false;
    }
    return true;
  };
  double low = 0;
  double high = 1e4;
  if (fits(high)) return infinity;
  while (high - low > 1e-9 * high) (fits((low + high) / 2) ? low : high) = (low + high) / 2;
  return low;
}

TEST(SpherePlacement, equals_the_largest_ball_found_by_bisection) {
  const auto meshed = fillets::mesh(
      {.radius = 4, .angle = std::numbers::pi / 2, .step = 1.5, .meshing = fillets::Meshing::jittered_flips});
  const TriangleMesh mesh = shapes::mesh(meshed.triangles);
  const Field field = placed(meshed.triangles);
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const double ball = largest_ball(mesh, f);
    if (ball < 1000) {
      EXPECT_NEAR(field.upper[f], ball, 1e-6 * ball) << "facet " << f;
    } else {
      EXPECT_GT(field.upper[f], 999) << "facet " << f;
    }
  }
}

TEST(SpherePlacement, reads_two_thirds_on_strips_of_split_squares) {
  const auto meshed = fillets::mesh({.radius = 6, .angle = std::numbers::pi / 2, .step = 0.5});
  const Field field = placed(meshed.triangles);
  double most = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (meshed.part[i] == fillets::Part::rounding && std::isfinite(field.value[i]) && field.value[i] < 5)
      most = std::max(most, field.value[i]);
  }
  EXPECT_NEAR(most, 4, 0.05);
}

TEST(SpherePlacement, misses_a_sharp_edge_between_large_facets) {
  const double w = 20 * std::sqrt(0.5);
  const Vec3d a{0, 0, 0}, b{0, 40, 0}, p{-w, 0, -w}, q{-w, 40, -w}, u{w, 0, -w}, v{w, 40, -w};
  const Field field = placed({{p, a, b}, {p, b, q}, {a, u, v}, {a, v, b}});
  EXPECT_NEAR(field.upper[0], 20.0 / 3, 0.05);
  EXPECT_EQ(field.lower[0], 0) << "its other edges are free";
}

TEST(SpherePlacement, sees_neighbours_across_t_junctions_and_none_on_a_free_facet) {
  const Vec3d a{0, 0, 0}, b{0, 40, 0}, p{-5, 20, 0}, v{0, 20, -5}, m{0, 10, 0};
  const Field field = placed({{p, a, b}, {a, v, m}, {m, v, b}});
  EXPECT_NEAR(field.upper[0], 5.0 / 3, 0.01);
  const Field alone = placed({{p, a, b}});
  EXPECT_EQ(alone.absence[0], Absence::open);
  EXPECT_TRUE(std::isnan(alone.value[0]));
}

}  // namespace
}  // namespace gabarit
