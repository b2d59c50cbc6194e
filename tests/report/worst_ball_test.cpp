#include "report/worst_ball.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/report/sample_report.h"
#include "tests/report/wall_report.h"

namespace gabarit {
namespace {

constexpr Limit at_least_3{Limit::Kind::at_least, 3, 0};

WorstBall ball_of(const WallReport& wall) {
  return worst_ball(wall.model.mesh, wall.rule(), wall.rule().worst).value();
}

void expect_through_both_ends(const WorstBall& ball) {
  EXPECT_NEAR(length(ball.direction), 1, 1e-12);
  EXPECT_NEAR(length(ball.centre() - ball.touch), ball.diameter / 2, 1e-9);
  EXPECT_NEAR(length(ball.centre() - ball.contact), ball.diameter / 2, 1e-9);
}

TEST(WorstBall, of_a_plate_stands_across_it) {
  const WallReport wall(shapes::gridded_box({0, 0, 0}, {40, 30, 2}, 8), at_least_3);
  const WorstBall ball = ball_of(wall);
  expect_through_both_ends(ball);
  EXPECT_NEAR(ball.diameter, 2, 1e-12);
  EXPECT_EQ(ball.limit, 3);
  EXPECT_NEAR(std::fabs(ball.direction.z), 1, 1e-9);
  EXPECT_NEAR(ball.centre().z, 1, 1e-9);
}

TEST(WorstBall, of_a_wedge_goes_through_both_sides_and_lies_in_the_material) {
  const WallReport wall(shapes::extrude({{0, 0}, {30, 0}, {30, 8}}, 0, 10), at_least_3);
  const WorstBall ball = ball_of(wall);
  expect_through_both_ends(ball);
  EXPECT_GT(ball.centre().y, 0);
  EXPECT_LT(ball.centre().y, ball.centre().x * 8 / 30);
}

TEST(WorstBall, of_a_gap_lies_outside_the_part) {
  const auto blocks = shapes::joined(shapes::gridded_box({0, 0, 0}, {20, 20, 10}, 5),
                                     shapes::gridded_box({0, 0, 10.6}, {20, 20, 20}, 5));
  const WorstBall ball = ball_of(WallReport(blocks, at_least_3, "clearance"));
  expect_through_both_ends(ball);
  EXPECT_NEAR(ball.centre().z, 10.3, 1e-9);
}

TEST(WorstBall, of_a_ray_is_its_length) {
  const WorstBall ball =
      ball_of(WallReport(shapes::gridded_box({0, 0, 0}, {40, 30, 2}, 8), at_least_3, "thickness", "ray"));
  EXPECT_FALSE(ball.ball);
  EXPECT_NEAR(length(ball.contact - ball.touch), ball.diameter, 1e-12);
}

TEST(WorstBall, is_none_without_a_value_a_contact_or_a_measure_of_balls) {
  const WallReport wall(shapes::gridded_box({0, 0, 0}, {40, 30, 2}, 8), at_least_3);
  const auto with = [&](auto change) {
    Worst worst = wall.rule().worst;
    change(worst);
    return worst_ball(wall.model.mesh, wall.rule(), worst).has_value();
  };
  EXPECT_TRUE(with([](Worst&) {}));
  EXPECT_FALSE(with([](Worst& w) { w.value = std::nan(""); }));
  EXPECT_FALSE(with([](Worst& w) { w.value = INFINITY; }));
  EXPECT_FALSE(with([](Worst& w) { w.contact = w.at; }));
  EXPECT_FALSE(with([](Worst& w) { w.at.x = std::nan(""); }));
  EXPECT_FALSE(with([](Worst& w) { w.contact = w.at + Vec3d{0, 0, 9}; })) << "no ball of 2 mm reaches so far";
  const SampleReport sample;
  const RuleResult& radius = sample.outcome.results[1];
  EXPECT_FALSE(worst_ball(sample.model.mesh, radius, radius.worst));
}

TEST(WorstBall, its_section_holds_o_the_contact_and_the_centre) {
  for (const auto& shape :
       {shapes::gridded_box({0, 0, 0}, {40, 30, 2}, 8),
        shapes::rotated(shapes::extrude({{0, 0}, {30, 0}, {30, 8}}, 0, 10), normalized(Vec3d{1, 2, 3}), 1)}) {
    const WallReport wall(shape, at_least_3);
    const WorstBall ball = ball_of(wall);
    const Camera camera = section_camera(ball, wall.model.box, 1.5);
    for (const Vec3d& p : {ball.touch, ball.contact, ball.centre()}) {
      EXPECT_NEAR(dot(p - camera.target, camera.toward()), 0, 1e-6);
      const PagePoint on_page = project(camera, p);
      EXPECT_LT(std::fabs(on_page.x), camera.width / 2);
      EXPECT_LT(std::fabs(on_page.y), camera.height / 2);
    }
    EXPECT_GT(project(camera, ball.touch).y, project(camera, ball.centre()).y) << "O is above";
    EXPECT_NEAR(dot(camera.right, camera.up), 0, 1e-12);
    EXPECT_NEAR(camera.width / camera.height, 1.5, 1e-12);
  }
}

TEST(WorstBall, a_limit_far_larger_than_the_ball_does_not_make_it_a_dot) {
  WorstBall ball{{0, 0, 0}, {0, 0, -1e-3}, {0, 0, -1}, 1e-3, true, 100};
  Box3d part;
  part.add(Vec3d{-5, -5, -5}), part.add(Vec3d{5, 5, 5});
  EXPECT_LT(section_camera(ball, part, 1).height, 0.02);
}

}  // namespace
}  // namespace gabarit
