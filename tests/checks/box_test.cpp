#include "checks/box.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

const Box3d unit{{0, 0, 0}, {1, 1, 1}};

bool triangle(Vec3d a, Vec3d b, Vec3d c) { return meets(unit, std::array{a, b, c}); }
bool segment(Vec3d a, Vec3d b) { return meets(unit, std::array{a, b}); }

TEST(BoxSelector, triangles_that_only_seem_to_meet_the_box_do_not) {
  EXPECT_TRUE(triangle({0.5, 0.5, 0.5}, {5, 5, 5}, {5, 0, 5})) << "a corner inside";
  EXPECT_TRUE(triangle({-9, -9, 0.5}, {9, -9, 0.5}, {0, 9, 0.5})) << "the box within the triangle";
  EXPECT_TRUE(triangle({1, 1, 1}, {2, 2, 2}, {2, 1, 2})) << "a shared corner";
  EXPECT_FALSE(triangle({1.1, 2, 0}, {2, 1.1, 0}, {2, 2, 1})) << "past an edge, boxes overlap not";
  EXPECT_FALSE(triangle({-1, 2.01, 0.5}, {2.01, -1, 3.5}, {5, 5, 9})) << "separated by an edge only";
  EXPECT_FALSE(triangle({3.01, 0, 0}, {0, 3.01, 0}, {0, 0, 3.01})) << "separated by its plane";
  EXPECT_TRUE(triangle({2.99, 0, 0}, {0, 2.99, 0}, {0, 0, 2.99}));
}

TEST(BoxSelector, segments_and_points_are_met_exactly) {
  EXPECT_TRUE(segment({-1, 0.5, 0.5}, {2, 0.5, 0.5}));
  EXPECT_FALSE(segment({-1, 1.5, 0.5}, {0.49, 3, 0.5}));
  EXPECT_FALSE(segment({1.2, 0.9, 0.5}, {0.9, 1.2, 0.5})) << "boxes overlap, the segment cuts the corner off";
  EXPECT_TRUE(segment({1, 1, 1}, {1, 1, 1})) << "a point";
  EXPECT_FALSE(segment({1, 1, 1.001}, {1, 1, 1.001}));
}

// The triangle clipped by the sides of the box one after another; empty when they miss each other.
bool clipped_meets(std::vector<Vec3d> polygon) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const auto inside = [&](const Vec3d& p) { return sign > 0 ? 1 - p[axis] : p[axis]; };
      std::vector<Vec3d> kept;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        if (inside(a) >= 0) kept.push_back(a);
        if ((inside(a) < 0) != (inside(b) < 0))
          kept.push_back(a + (b - a) * (inside(a) / (inside(a) - inside(b))));
      }
      polygon = kept;
    }
  }
  return !polygon.empty();
}

TEST(BoxSelector, agrees_with_clipping_on_random_triangles) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.5, 2.5);
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<Vec3d, 3> t;
    for (Vec3d& corner : t) corner = {coordinate(random), coordinate(random), coordinate(random)};
    const bool expected = clipped_meets({t.begin(), t.end()});
    EXPECT_EQ(meets(unit, t), expected) << i;
    met += expected ? 1 : 0;
  }
  EXPECT_GT(met, 2000);
  EXPECT_LT(met, 18000);
}

TEST(BoxSelector, selects_facets_and_edges_of_a_model) {
  const Model model = shapes::model(shapes::gridded_box({0, 0, 0}, {10, 10, 10}, 5));
  Arguments arguments;
  arguments.set("from", Vec3d{-1, -1, 9});
  arguments.set("to", Vec3d{11, 11, 20});
  const Region region = box_selector.select(Scene(model, Device::cpu(1)), {}, arguments);
  for (FacetId f = 0; f < model.mesh.facet_count(); ++f) {
    double top = -1e9;
    for (const Vec3d& corner : model.mesh.corners(f)) top = std::max(top, corner.z);
    EXPECT_EQ(region.facets[f], top >= 9 ? Selected::yes : Selected::no);
    for (int e = 0; e < 3; ++e) {
      const double end = std::max(model.mesh.corner(f, e).z, model.mesh.corner(f, (e + 1) % 3).z);
      EXPECT_EQ(region.edge(f, e), end >= 9 ? Selected::yes : Selected::no);
    }
  }
}

}  // namespace
}  // namespace gabarit
