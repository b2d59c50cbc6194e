// The column's contacts, part by part, against the list that comes with the example.
#include <gtest/gtest.h>

#include "checks/vertical_cylinder_contact.h"
#include "tests/examples/built.h"
#include "tests/examples/true_radius.h"

namespace gabarit::motorcycle {
namespace {

std::vector<TouchedPart> touched(const Built& built, Motion motion) {
  const Scene scene(built.model, Device::cpu());
  gabarit::Setup setup;
  setup.sag = built.tessellation.sag;
  setup.height_band = {0, 2000};
  const VerticalCylinder column{.radius = 150, .motion = motion, .tolerance = built.tessellation.sag};
  return touched_parts(built.parts, built.grids, vertical_cylinder_contact(scene, setup, column));
}

Expectation seen(const TouchedPart& forward, const TouchedPart& any) {
  if (forward.yes > 0) return forward.radius < 4 ? Expectation::violates : Expectation::round;
  return any.yes > 0 ? Expectation::rear_facing : Expectation::out_of_reach;
}

TEST(MotorcycleContact, every_part_is_touched_as_the_list_says_and_as_round_as_it_says) {
  const Built& built = coarse();
  const auto forward = touched(built, Motion::forward), any = touched(built, Motion::any);
  for (std::size_t i = 0; i < built.parts.size(); ++i) {
    const Part& part = built.parts[i];
    EXPECT_STREQ(name(seen(forward[i], any[i])), name(part.expectation)) << part.name;
    if (part.expectation == Expectation::out_of_reach) continue;
    const double radius = part.expectation == Expectation::rear_facing ? any[i].radius : forward[i].radius;
    EXPECT_GE(radius, 0.95 * part.true_radius) << part.name;
    if (part.expectation == Expectation::violates) {
      EXPECT_LE(radius, 1.05 * part.true_radius) << part.name;
    }
  }
}

TEST(MotorcycleContact, the_list_holds_every_kind) {
  std::size_t sharp = 0, between = 0, round = 0, hidden = 0;
  for (const Part& part : coarse().parts) {
    const bool violates = part.expectation == Expectation::violates;
    sharp += violates && part.true_radius < 3.2;
    between += violates && part.true_radius > 3.2;
    round += part.expectation == Expectation::round;
    hidden += part.expectation == Expectation::out_of_reach && part.true_radius < 3.2;
    EXPECT_EQ(violates, violates && part.true_radius < 4) << part.name;
  }
  EXPECT_GE(sharp, 4U);
  EXPECT_GE(between, 3U);
  EXPECT_GE(round, 8U);
  EXPECT_GE(hidden, 8U);
}

}  // namespace
}  // namespace gabarit::motorcycle
