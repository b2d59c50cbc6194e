// Walls, gaps, radii and contacts of models with exact surfaces: the same bits on every device at hand.
#include <gtest/gtest.h>

#include "checks/radius.h"
#include "checks/vertical_cylinder_contact.h"
#include "tests/checks/wall_fields.h"
#include "tests/gpu/other_devices.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using ExactSameFields = step_shapes::StepFiles;

void expect_equal(const Field& a, const Field& b, const std::string& what) {
  EXPECT_EQ(a.facets, b.facets) << what;
  // As they are: two values that are missing are equal too.
  const auto same = [](const std::vector<double>& x, const std::vector<double>& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                      [](double p, double q) { return p == q || (std::isnan(p) && std::isnan(q)); });
  };
  EXPECT_TRUE(same(a.value, b.value)) << what;
  EXPECT_TRUE(same(a.lower, b.lower)) << what;
  EXPECT_TRUE(same(a.upper, b.upper)) << what;
  EXPECT_EQ(a.absence, b.absence) << what;
}

TEST_F(ExactSameFields, of_every_measure_on_every_device) {
  LoadOptions coarse;
  coarse.sag = 0.6;
  const Model model = step_shapes::loaded(step(step_shapes::tube(10, 8.8, 3)), coarse);
  for (const Measure* of : {&thickness_measure, &clearance_measure, &radius_measure}) {
    Wanted wanted{.sag = 0.6, .limit = 30, .resolution = 30, .device = plain_cpu};
    const Field expected = measure(*of, model, wanted);
    for (const auto& [name, device] : other_devices()) {
      wanted.device = device;
      expect_equal(expected, measure(*of, model, wanted), of->name + " on " + name);
    }
  }
}

TEST_F(ExactSameFields, of_contacts_on_every_device) {
  const Model model = step_shapes::loaded(step(step_shapes::rounded_box(120, 90, 40, 15)));
  const auto region_on = [&](const Device& device) {
    return vertical_cylinder_contact(Scene(model, device), {}, {.radius = 150});
  };
  const Region expected = region_on(plain_cpu);
  for (const auto& [name, device] : other_devices()) {
    const Region found = region_on(device);
    EXPECT_EQ(expected.facets, found.facets) << name;
    EXPECT_EQ(expected.edges, found.edges) << name;
    EXPECT_EQ(expected.depth, found.depth) << name;
  }
}

}  // namespace
}  // namespace gabarit
