// Bodies whose thickness is known at every place.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
