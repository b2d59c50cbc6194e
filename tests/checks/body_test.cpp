#include "checks/body.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

TEST(Body, patterns_fit_whole_names) {
  EXPECT_TRUE(matches("tank", "tank"));
  EXPECT_FALSE(matches("tank", "tank 2"));
  EXPECT_FALSE(matches("tank", "Tank")) << "case counts";
  EXPECT_TRUE(matches("tank*", "tank"));
  EXPECT_TRUE(matches("*mirror*", "left mirror rim"));
  EXPECT_TRUE(matches("a*b*c", "a b b c"));
  EXPECT_FALSE(matches("a*b*c", "a b b c d"));
  EXPECT_TRUE(matches("t?nk", "tank"));
  EXPECT_FALSE(matches("tank?", "tank"));
  EXPECT_TRUE(matches("T?r", "Tür")) << "one character of two bytes";
  EXPECT_TRUE(matches("*??", "車体"));
  EXPECT_FALSE(matches("*???", "車体"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_FALSE(matches("", "a"));
}

TEST(Body, many_stars_do_not_take_long) {
  std::string pattern;
  for (int i = 0; i < 50; ++i) pattern += "*a";
  EXPECT_FALSE(matches(pattern + "b", std::string(5000, 'a')));
}

Model three_bodies() {
  Model model = shapes::model({{Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}},
                               {Vec3d{0, 0, 1}, Vec3d{1, 0, 1}, Vec3d{0, 1, 1}},
                               {Vec3d{0, 0, 2}, Vec3d{1, 0, 2}, Vec3d{0, 1, 2}}});
  model.bodies = {"tank left", "seat", "tank right"};
  model.mesh.body = {0, 1, 2};
  return model;
}

Region select(const Model& model, const std::string& name) {
  Arguments arguments;
  arguments.set("name", name);
  return body_selector.select(Scene(model, Device::cpu(1)), {}, arguments);
}

TEST(Body, facets_follow_their_body) {
  const Region region = select(three_bodies(), "tank*");
  EXPECT_THAT(region.facets, testing::ElementsAre(Selected::yes, Selected::no, Selected::yes));
  EXPECT_TRUE(region.notes.empty());
}

TEST(Body, a_pattern_without_a_body_is_noted_with_the_names_there_are) {
  const Region region = select(three_bodies(), "fork");
  EXPECT_THAT(region.facets, testing::Each(Selected::no));
  EXPECT_THAT(region.notes,
              testing::ElementsAre("No body is named `fork`; the model has `tank left`, `seat`, `tank "
                                   "right`."));
}

}  // namespace
}  // namespace gabarit
