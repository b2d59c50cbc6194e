#include "report/camera.h"

#include <cmath>

#include <gmock/gmock.h>

#include "report/scale_bar.h"
#include "report/triad.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

const Box3d motorcycle{{-200, -400, 0}, {1900, 400, 1200}};

const Camera& camera_of(const std::vector<NamedView>& views, const std::string& name) {
  for (const NamedView& view : views) {
    if (view.name == name) return view.camera;
  }
  throw std::out_of_range(name);
}

TEST(fixed_views, are_named_as_the_driver_would) {
  std::vector<std::string> names;
  for (const NamedView& view : fixed_views(motorcycle, {}, 1.6)) names.push_back(view.name);
  EXPECT_THAT(names, testing::ElementsAre("front", "rear", "left", "right", "top", "bottom",
                                          "front left, from above", "rear right, from above"));
}

TEST(fixed_views, look_from_where_their_names_say) {
  const Frame frame{{0, 0, 1}, {-1, 0, 0}, 0};  // the left is -y
  const auto views = fixed_views(motorcycle, frame, 1.6);
  EXPECT_EQ(camera_of(views, "front").toward(), (Vec3d{-1, 0, 0}));
  EXPECT_EQ(camera_of(views, "rear").toward(), (Vec3d{1, 0, 0}));
  EXPECT_EQ(camera_of(views, "left").toward(), (Vec3d{0, -1, 0}));
  EXPECT_EQ(camera_of(views, "right").toward(), (Vec3d{0, 1, 0}));
  EXPECT_EQ(camera_of(views, "top").toward(), (Vec3d{0, 0, 1}));
  EXPECT_EQ(camera_of(views, "bottom").toward(), (Vec3d{0, 0, -1}));
  const Vec3d front_left = camera_of(views, "front left, from above").toward();
  EXPECT_TRUE(front_left.x < 0 && front_left.y < 0 && front_left.z > 0);
  const Vec3d rear_right = camera_of(views, "rear right, from above").toward();
  EXPECT_TRUE(rear_right.x > 0 && rear_right.y > 0 && rear_right.z > 0);
}

TEST(fixed_views, from_the_side_stand_upright_and_show_the_front_where_it_is) {
  const auto views = fixed_views(motorcycle, {}, 1.6);
  const Vec3d front_wheel{-100, 0, 0};
  const Vec3d lamp{-100, 0, 900};
  EXPECT_LT(project(camera_of(views, "left"), front_wheel).x, 0);
  EXPECT_GT(project(camera_of(views, "right"), front_wheel).x, 0);
  EXPECT_LT(project(camera_of(views, "top"), front_wheel).x, 0);
  for (const char* const name : {"front", "rear", "left", "right", "front left, from above"}) {
    const Camera& camera = camera_of(views, name);
    EXPECT_GT(project(camera, lamp).y, project(camera, front_wheel).y) << name;
  }
}

TEST(fixed_views, show_the_whole_box_at_the_aspect_asked_for_and_waste_little) {
  for (const Frame& frame : {Frame{}, Frame{{0, 1, 0}, {0, 0, 1}, 0}}) {
    for (const double aspect : {0.5, 1.0, 1.6}) {
      for (const NamedView& view : fixed_views(motorcycle, frame, aspect)) {
        const Camera& c = view.camera;
        double x = 0;
        double y = 0;
        for (int i = 0; i < 8; ++i) {
          const PagePoint p = project(c, {(i & 1) != 0 ? motorcycle.min.x : motorcycle.max.x,
                                          (i & 2) != 0 ? motorcycle.min.y : motorcycle.max.y,
                                          (i & 4) != 0 ? motorcycle.min.z : motorcycle.max.z});
          x = std::max(x, std::abs(p.x) / (c.width / 2));
          y = std::max(y, std::abs(p.y) / (c.height / 2));
        }
        EXPECT_NEAR(c.width / c.height, aspect, 1e-12);
        EXPECT_NEAR(std::max(x, y), 1 / 1.08, 1e-9) << view.name;
        EXPECT_NEAR(dot(c.right, c.up), 0, 1e-12);
        EXPECT_NEAR(length(c.right), 1, 1e-12);
        EXPECT_NEAR(length(c.up), 1, 1e-12);
      }
    }
  }
}

TEST(fixed_views, of_facets_come_closer_than_those_of_their_box) {
  const TriangleMesh mesh = shapes::mesh(shapes::moved(shapes::sphere(50, 40, 80), {7, 8, 9}));
  for (const NamedView& view : fixed_views(mesh, {}, 1.6)) {
    EXPECT_NEAR(view.camera.height, 1.08 * 100, 0.5) << view.name;
    EXPECT_NEAR(length(view.camera.target - Vec3d{7, 8, 9}), 0, 0.2) << view.name;
  }
}

TEST(fixed_views, of_facets_do_not_mind_what_is_not_finite_or_not_there) {
  TriangleMesh mesh = shapes::mesh(shapes::box({-10, -10, -10}, {10, 10, 10}));
  const auto views = fixed_views(mesh, {}, 1);
  mesh.vertices.push_back({1e9, 1e9, 1e9});  // no facet uses it
  mesh.vertices.push_back({NAN, 0, 0});
  mesh.facets.push_back({0, 1, 9});
  const auto others = fixed_views(mesh, {}, 1);
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(others[i].camera.width, views[i].camera.width);
    EXPECT_EQ(others[i].camera.target, views[i].camera.target);
  }
  EXPECT_EQ(fixed_views(TriangleMesh{}, {}, 1).size(), 8U);
}

TEST(fixed_views, of_nothing_or_a_point_or_the_whole_universe_are_still_views) {
  for (const Box3d& box : {Box3d{}, Box3d{{1, 2, 3}, {1, 2, 3}}, Box3d{{-1.7e308, -1, 0}, {1.7e308, 1, 0}}}) {
    for (const NamedView& view : fixed_views(box, {}, 1.6)) {
      EXPECT_GT(view.camera.width, 0);
      EXPECT_TRUE(std::isfinite(view.camera.width) && is_finite(view.camera.target));
    }
  }
}

TEST(close_up, looks_against_the_normal_with_up_upwards) {
  const Vec3d outward = normalized(Vec3d{1, 2, 3});
  const Camera c = close_up({10, 20, 30}, outward, {}, 50, 2);
  EXPECT_NEAR(length(c.toward() - outward), 0, 1e-12);
  EXPECT_GT(c.up.z, 0);
  EXPECT_NEAR(c.right.z, 0, 1e-12);
  EXPECT_EQ(c.width, 50);
  EXPECT_EQ(c.height, 25);
  EXPECT_EQ(c.target, (Vec3d{10, 20, 30}));
}

TEST(close_up, from_straight_above_or_without_a_normal_is_still_a_view) {
  for (const Vec3d& outward :
       {Vec3d{0, 0, 1}, Vec3d{0, 0, -1}, Vec3d{1e-9, 0, 1}, Vec3d{}, Vec3d{NAN, 0, 0}}) {
    const Camera c = close_up({}, outward, {}, 50, 1);
    EXPECT_NEAR(dot(c.right, c.up), 0, 1e-12);
    EXPECT_NEAR(length(cross(c.right, c.up)), 1, 1e-12);
  }
  EXPECT_EQ(close_up({}, {0, 0, 1}, {}, 50, 1).toward(), (Vec3d{0, 0, 1}));
}

TEST(scale_bar, is_the_longest_round_length_that_fits) {
  Camera camera;
  camera.width = 2300;
  const ScaleBar bar = scale_bar(camera, 0.25);
  EXPECT_EQ(bar.length, 500);
  EXPECT_EQ(bar.label, "500 mm");
  EXPECT_EQ(bar.divisions, 5);
  EXPECT_NEAR(bar.share * camera.width, 500, 1e-9);
}

TEST(scale_bar, speaks_of_metres_and_of_tenths_of_millimetres) {
  Camera camera;
  camera.width = 10000;
  EXPECT_EQ(scale_bar(camera).label, "2 m");
  EXPECT_EQ(scale_bar(camera).divisions, 4);
  camera.width = 0.9;
  EXPECT_EQ(scale_bar(camera).label, "0.2 mm");
  camera.width = 0;
  EXPECT_EQ(scale_bar(camera).length, 0);
}

TEST(triad, of_the_left_view_has_x_to_the_right_z_up_and_y_away) {
  const auto axes = triad(camera_of(fixed_views(motorcycle, {}, 1.6), "left"));
  EXPECT_EQ(axes[0].name, 'y');  // the farthest comes first
  EXPECT_EQ(axes[0].toward, -1);
  EXPECT_EQ(axes[1].name, 'x');
  EXPECT_EQ(axes[1].tip.x, 1);
  EXPECT_EQ(axes[2].name, 'z');
  EXPECT_EQ(axes[2].tip.y, 1);
}

TEST(triad, axes_are_projected_unit_arrows_ordered_by_depth) {
  const Camera camera = camera_of(fixed_views(motorcycle, {}, 1.6), "front left, from above");
  double before = -1;
  for (const TriadAxis& axis : triad(camera)) {
    EXPECT_NEAR(std::hypot(axis.tip.x, axis.tip.y, axis.toward), 1, 1e-12);
    EXPECT_GE(axis.toward, before);
    before = axis.toward;
  }
}

}  // namespace
}  // namespace gabarit
