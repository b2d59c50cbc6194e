#include "rules/nearest_name.h"

#include <gtest/gtest.h>

namespace gabarit {
namespace {

const std::vector<std::string> known{"radius", "thickness", "clearance"};

TEST(NearestName, forgives_a_slip_but_not_another_word) {
  EXPECT_EQ(nearest_name("radus", known), "radius");
  EXPECT_EQ(nearest_name("raduis", known), "radius");
  EXPECT_EQ(nearest_name("Radius", known), "radius");
  EXPECT_EQ(nearest_name("thicknes", known), "thickness");
  EXPECT_EQ(nearest_name("weight", known), std::nullopt);
  EXPECT_EQ(nearest_name("", known), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(1000000, 'r'), known), std::nullopt);
}

TEST(NearestName, a_hint_lists_what_is_known) {
  EXPECT_EQ(name_hint("radus", known),
            "did you mean `radius`? known are: `radius`, `thickness`, `clearance`");
  EXPECT_EQ(name_hint("x", std::vector<std::string>{"radius"}), "the only one known is `radius`");
  EXPECT_EQ(name_hint("x", {}), "none is known");
}

}  // namespace
}  // namespace gabarit
