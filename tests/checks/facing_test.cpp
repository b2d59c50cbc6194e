#include "checks/facing.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

constexpr double degree = std::numbers::pi / 180;

Region select(const Model& model, const Value& direction, double within, const Setup& setup = {}) {
  Arguments arguments;
  arguments.set("direction", direction);
  arguments.set("within", within);
  return facing_selector.select(Scene(model, Device::cpu(1)), setup, arguments);
}

// The normals of the selected facets, each once.
std::vector<Vec3d> normals(const Model& model, const Region& region) {
  std::vector<Vec3d> found;
  for (FacetId f = 0; f < region.facets.size(); ++f) {
    const Vec3d n = facet_normal(model.mesh, f);
    if (region.facets[f] == Selected::yes && std::find(found.begin(), found.end(), n) == found.end()) {
      found.push_back(n);
    }
  }
  return found;
}

TEST(Facing, each_named_direction_selects_one_side_of_a_box) {
  const Model model = shapes::model(shapes::box({0, 0, 0}, {1, 2, 3}));
  const std::vector<std::pair<std::string, Vec3d>> sides{{"forward", {-1, 0, 0}}, {"rear", {1, 0, 0}},
                                                         {"up", {0, 0, 1}},       {"down", {0, 0, -1}},
                                                         {"left", {0, -1, 0}},    {"right", {0, 1, 0}}};
  for (const auto& [name, normal] : sides) {
    EXPECT_EQ(normals(model, select(model, name, 90 * degree)), std::vector{normal}) << name;
  }
}

TEST(Facing, a_turned_frame_turns_the_named_directions) {
  const Model model = shapes::model(shapes::box({0, 0, 0}, {1, 2, 3}));
  gabarit::Setup setup;
  setup.frame.up = {0, 1, 0};
  setup.frame.forward = {1, 0, 0};
  EXPECT_EQ(normals(model, select(model, std::string("up"), 45 * degree, setup)),
            (std::vector{Vec3d{0, 1, 0}}));
  EXPECT_EQ(normals(model, select(model, std::string("left"), 45 * degree, setup)),
            (std::vector{Vec3d{0, 0, -1}}));
}

TEST(Facing, the_angle_decides_strictly) {
  // A facet that is 30° away from up.
  const Model model = shapes::model(
      shapes::rotated({{Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}}}, {1, 0, 0}, 30 * degree));
  const Vec3d up{0, 0, 2};
  EXPECT_EQ(select(model, up, 30.01 * degree).facets[0], Selected::yes);
  EXPECT_EQ(select(model, up, 30 * degree).facets[0], Selected::no);
  EXPECT_EQ(select(model, up, 29.99 * degree).facets[0], Selected::no);
}

TEST(Facing, side_walls_do_not_face_forward_whatever_the_rounding) {
  const auto box = shapes::rounded_to_float(
      shapes::moved(shapes::gridded_box({0, 0, 0}, {100, 100, 100}, 10.0 / 3), {1234.567, 0.1, 0.7}));
  const Model model = shapes::model(box);
  EXPECT_EQ(normals(model, select(model, std::string("forward"), 90 * degree)).size(), 1U);
}

TEST(Facing, half_a_turn_selects_everything_that_has_a_normal) {
  const Model model = shapes::model({{Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}},
                                     {Vec3d{0, 0, 0}, Vec3d{0, 1, 0}, Vec3d{1, 0, 0}},
                                     {Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{2, 0, 0}}});
  EXPECT_EQ(select(model, std::string("up"), 180 * degree).facets,
            (std::vector{Selected::yes, Selected::yes, Selected::maybe}));
}

}  // namespace
}  // namespace gabarit
