#include "checks/radius.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "checks/turning.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

Field measured(const shapes::Triangles& triangles, double sag = 0.1) {
  const Model model = shapes::model(triangles, sag);
  Setup setup;
  setup.sag = sag;
  return measure_turning(Scene(model, Device::cpu()), setup, whole_model(model.mesh));
}

TEST(Radius, every_facet_of_a_box_touches_a_sharp_edge) {
  const Field field = measured(shapes::box({0, 0, 0}, {300, 200, 100}));
  ASSERT_EQ(field.size(), 12U);
  for (std::size_t i = 0; i < field.size(); ++i) {
    EXPECT_EQ(field.value[i], 0);
    EXPECT_EQ(field.lower[i], 0);
    EXPECT_NEAR(field.upper[i], 0.1 / (1 - std::cos(std::acos(-1.0) / 4)), 1e-6);
  }
}

TEST(Radius, what_lies_in_a_plane_away_from_the_edges_has_no_limit) {
  const auto triangles = shapes::gridded_box({0, 0, 0}, {50, 50, 50}, 5);
  const Model model = shapes::model(triangles);
  const Field field = measured(triangles);
  std::size_t inner = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vec3d c = model.mesh.centroid(field.facets[i]);
    const auto inside = [](double x) { return x < 1e-9 || x > 50 - 1e-9 || (x > 5 && x < 45); };
    if (!inside(c.x) || !inside(c.y) || !inside(c.z)) continue;
    ++inner;
    EXPECT_EQ(field.value[i], std::numeric_limits<double>::infinity());
    EXPECT_GT(field.lower[i], 1000);
  }
  EXPECT_EQ(inner, 6U * 8 * 8 * 2);
}

TEST(Radius, a_sphere_reads_its_radius) {
  for (const double radius : {2.0, 10.0, 100.0}) {
    const Field field = measured(shapes::sphere(radius, 40, 80), radius * 0.001);
    for (std::size_t i = 0; i < field.size(); ++i) {
      EXPECT_LE(field.lower[i], radius);
      EXPECT_GE(field.upper[i], radius);
      EXPECT_NEAR(field.value[i], radius, 0.05 * radius);
    }
  }
}

}  // namespace
}  // namespace gabarit
