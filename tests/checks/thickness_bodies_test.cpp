// Bodies whose thickness is known at every place.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/block_solid.h"
#include "tests/checks/wall_fields.h"

namespace gabarit {
namespace {

using shapes::Point2;
using shapes::Triangles;

TEST(Thickness, a_plate_of_2_mm_measures_2_mm) {
  for (const double step : {100.0, 7.0, 1.5}) {
    const Field field = thickness(shapes::gridded_box({0, 0, 0}, {40, 30, 2}, step));
    for (std::size_t i = 0; i < field.size(); ++i) {
      const bool side = field.at[i].z > 1e-9 && field.at[i].z < 2 - 1e-9;
      const double truth = !side ? 2 : std::fabs(field.at[i].x - 20) > 19.9 ? 40 : 30;
      EXPECT_NEAR(field.value[i], truth, 1e-12);
      EXPECT_NEAR(field.lower[i], truth, 1e-5 * truth);
      EXPECT_NEAR(field.upper[i], truth, 1e-12);
    }
  }
}

TEST(Thickness, a_tube_measures_its_wall) {
  for (const int segments : {36, 90}) {
    std::vector<Point2> profile{{8, 0}, {10, 0}, {10, 6}, {8, 6}, {8, 0}};
    const auto tube = shapes::revolve(profile, segments);
    const Field field = thickness(tube);
    expect_truth(
        tube, field, [&](const Vec3d& p) { return p.z < 0.1 || p.z > 5.9 ? NAN : 2.0; },
        segments > 40 ? 0.01 : 0.02);
  }
}

TEST(Thickness, a_ball_a_rod_and_a_torus_measure_their_diameters) {
  const auto ball = shapes::sphere(10, 40, 80);
  expect_truth(
      ball, thickness(ball), [](const Vec3d&) { return 20.0; }, 0.011);
  const auto rod = shapes::revolve({{0, 0}, {5, 0}, {5, 20}, {0, 20}}, 72);
  expect_truth(
      rod, thickness(rod), [](const Vec3d& p) { return p.z < 0.1 || p.z > 19.9 ? 20.0 : 10.0; }, 0.01);
  const auto torus = shapes::torus(30, 4, 120, 40);
  expect_truth(
      torus, thickness(torus), [](const Vec3d&) { return 8.0; }, 0.011);
}

TEST(Thickness, a_shell_measures_its_wall) {
  const auto shell = shapes::joined(shapes::sphere(10, 40, 80), shapes::flipped(shapes::sphere(9, 40, 80)));
  expect_truth(
      shell, thickness(shell), [](const Vec3d&) { return 1.0; }, 0.03);
}

TEST(Thickness, half_a_millimetre_on_a_metre_far_from_the_origin) {
  const Vec3d far{52000, -31000, 8000};
  const auto plate = shapes::gridded_box(far, far + Vec3d{1000, 700, 0.5}, 50);
  const Field field = thickness(plate);
  EXPECT_NEAR(least_value(field), 0.5, 1e-9);
  EXPECT_GT(least_lower(field), 0.4999);
}

TEST(Thickness, half_a_millimetre_of_a_bent_wall_on_a_metre_far_from_the_origin) {
  const Vec3d far{-42000, 13000, 7000};
  std::vector<Point2> profile{{500, 0}, {500.5, 0}, {500.5, 40}, {500, 40}, {500, 0}};
  const auto tube = shapes::moved(shapes::revolve(profile, 720), far);
  const Field field = thickness(tube, at_least(0.45));
  const auto truth = [&](const Vec3d& p) { return p.z < 7000.1 || p.z > 7039.9 ? NAN : 0.5; };
  expect_truth(tube, field, truth, 0.01);
}

// At a distance s from the tip of a wedge the ball between its sides is 2 s tan(angle / 2) wide.
TEST(Thickness, a_wedge_is_as_thick_as_the_ball_between_its_sides) {
  for (const double degrees : {5.0, 20.0, 40.0, 55.0}) {
    const double a = degrees * std::numbers::pi / 180;
    const auto wedge = prism({{0, 0}, {40, 0}, {40 * std::cos(a), 40 * std::sin(a)}}, 20);
    const Field field = thickness(wedge, {.parameters = {{"step", "1 mm"}}});
    std::size_t sides = 0;
    for (std::size_t i = 0; i < field.size(); ++i) {
      const double s = std::hypot(field.at[i].x, field.at[i].y);
      const bool end = field.at[i].z < 1e-9 || field.at[i].z > 20 - 1e-9;
      if (field.at[i].x > 40 * std::cos(a) - 1e-9 && s > 30) {
        EXPECT_EQ(field.value[i], INFINITY) << "no wall lies opposite the third side";
        continue;
      }
      if (end) continue;
      ++sides;
      EXPECT_NEAR(field.value[i], 2 * s * std::tan(a / 2), 1e-9) << degrees;
      EXPECT_EQ(field.lower[i], 0) << "it reaches the tip";
    }
    EXPECT_EQ(sides, 4U);
  }
}

// 2 mm with edges rounded over the whole width. At the very edge no wall lies opposite: within 30 degrees of
// it the ball of method wall is that of the whole plate, that of method sphere is as wide as the plate.
TEST(Thickness, a_plate_with_rounded_edges_is_as_thick_there_as_elsewhere) {
  std::vector<Point2> outline = shapes::arc({20, 1}, 1, -std::numbers::pi / 2, std::numbers::pi / 2, 24);
  for (const Point2& p : shapes::arc({0, 1}, 1, std::numbers::pi / 2, 3 * std::numbers::pi / 2, 24))
    outline.push_back(p);
  const auto plate = shapes::extrude(outline, 0, 15, 10);
  const auto truth = [](double most, double from_end) {
    return [most, from_end](const Vec3d& p) {
      const bool end = p.z < from_end || p.z > 15 - from_end, edge = p.x > 20 + most || p.x < -most;
      return end || edge ? NAN : 2.0;
    };
  };
  const double steep = std::sin(55 * std::numbers::pi / 180);
  expect_truth(plate, thickness(plate, at_least(1.8)), truth(steep, 0.1), 0.01);
  Wanted sphere = at_least(1.8);
  sphere.parameters = {{"method", "sphere"}};
  expect_truth(plate, thickness(plate, sphere), truth(2, 3), 0.04);
}

// A base of 3 mm with a rib of 2 mm: under the rib the ball is stopped by the two edges at its root.
TEST(Thickness, a_rib_is_measured_across_and_its_root_by_its_edges) {
  shapes::BlockSolid solid;
  solid.lines = {{{0, 19, 21, 40}, {0, 30}, {0, 3, 15}}};
  solid.filled = [](int i, int, int k) { return i == 1 || k == 0; };
  const TriangleMesh mesh = shapes::surface(solid, 0.5);
  Triangles rib;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) rib.push_back(mesh.corners(f));
  const Field field = thickness(rib);
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vec3d c = mesh.centroid(field.facets[i]), n = facet_normal(mesh, field.facets[i]);
    if (c.y < 3 || c.y > 27) continue;
    if (std::fabs(n.x) > 0.5 && c.z > 3 && std::fabs(c.x - 20) < 2) {
      EXPECT_NEAR(field.value[i], 2, 1e-9);
    }
    if (n.z < -0.5 && std::fabs(c.x - 20) > 4) {
      EXPECT_NEAR(field.value[i], 3, 1e-9);
    }
    if (n.z < -0.5 && std::fabs(c.x - 20) < 0.5) {
      const double aside = 1 - std::fabs(field.at[i].x - 20);  // from the nearer edge
      EXPECT_NEAR(field.value[i], (aside * aside + 9) / 3, 1e-9);
    }
  }
}

TEST(Thickness, clearance_is_the_width_of_a_slot) {
  const auto blocks = shapes::joined(shapes::gridded_box({0, 0, 0}, {20, 20, 10}, 5),
                                     shapes::gridded_box({0, 0, 10.6}, {20, 20, 20}, 5));
  const Field field = measure(clearance_measure, shapes::model(blocks));
  for (std::size_t i = 0; i < field.size(); ++i) {
    const bool slot =
        std::fabs(field.at[i].z - 10.3) < 0.31 && (field.at[i].z == 10 || field.at[i].z == 10.6);
    if (slot) {
      EXPECT_NEAR(field.value[i], 0.6, 1e-9);
    } else {
      EXPECT_EQ(field.value[i], INFINITY);
      EXPECT_GE(field.lower[i], 20) << "a limit from below is passed";
    }
    EXPECT_EQ(field.absence[i], Absence::none);
  }
}

}  // namespace
}  // namespace gabarit
