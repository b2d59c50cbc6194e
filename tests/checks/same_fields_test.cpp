// Whole checks: every measure and every contact on every kind of model, the same bits on every device at
// hand.
#include <gtest/gtest.h>

#include "checks/radius.h"
#include "checks/vertical_cylinder_contact.h"
#include "tests/block_solid.h"
#include "tests/checks/field_bits.h"
#include "tests/checks/wall_fields.h"
#include "tests/gpu/other_devices.h"

namespace gabarit {
namespace {

TriangleMesh casting() { return shapes::with_facets(shapes::ribbed_casting(), 300); }

shapes::Triangles triangles_of(const TriangleMesh& mesh) {
  shapes::Triangles out;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) out.push_back(mesh.corners(f));
  return out;
}

shapes::Triangles open_box() {
  shapes::Triangles all = shapes::gridded_box({0, 0, 0}, {30, 20, 10}, 5);
  all.resize(all.size() - 12);
  return all;
}

// A facet without area and one that is there twice.
shapes::Triangles with_defects() {
  shapes::Triangles all = shapes::box({0, 0, 0}, {30, 20, 2});
  all.push_back(all.front());
  all.push_back({{{0, 0, 0}, {15, 10, 0}, {30, 20, 0}}});
  return all;
}

struct Kind {
  const char* name;
  shapes::Triangles (*make)();
};

const std::vector<Kind> kinds{
    {"l_bracket", [] { return l_bracket(3, 4); }},
    {"groove", [] { return grooved(1); }},
    {"tapered_plate", [] { return tapered_plate(); }},
    {"turned_plate",
     [] {
       return shapes::rotated(tapered_plate(), normalized(Vec3d{1, 2, 3}), 0.7);
     }},
    {"torus", [] { return shapes::torus(20, 5, 24, 12); }},
    {"ball_far_away",
     [] {
       return shapes::moved(shapes::sphere(10, 10, 20), {5000, -3000, 700});
     }},
    {"casting", [] { return triangles_of(casting()); }},
    {"open_box", open_box},
    {"with_defects", with_defects},
};

class SameFields : public testing::TestWithParam<Kind> {
 protected:
  const Model model = shapes::model(GetParam().make());

  template <class Work>
  void expect_same_bits(const std::string& what, Work&& work) {
    const Bits expected = bits_of(work(plain_cpu));
    EXPECT_FALSE(expected.empty());
    for (const auto& [name, device] : other_devices())
      EXPECT_TRUE(expected == bits_of(work(device))) << what << " on " << name;
  }
};

TEST_P(SameFields, of_walls_and_gaps_by_every_method) {
  for (const Measure* measured : {&thickness_measure, &clearance_measure}) {
    for (const char* method : {"wall", "sphere", "ray"}) {
      expect_same_bits(measured->name + " by " + method, [&](const Device& device) {
        return measure(*measured, model,
                       {.parameters = {{"method", method}}, .limit = 10, .resolution = 10, .device = device});
      });
    }
  }
}

TEST_P(SameFields, of_radii_by_every_method) {
  for (const char* method : {"turning", "sphere placement"}) {
    expect_same_bits(method, [&](const Device& device) {
      return measure(radius_measure, model,
                     {.parameters = {{"method", method}}, .limit = 4, .device = device});
    });
  }
}

TEST_P(SameFields, of_contacts_by_every_method_and_motion) {
  for (const VerticalCylinder& column :
       {VerticalCylinder{.radius = 40, .motion = Motion::any},
        VerticalCylinder{.radius = 40, .motion = Motion::sweep},
        VerticalCylinder{
            .radius = 40, .motion = Motion::forward, .method = ContactMethod::dexel, .spacing = 4}}) {
    expect_same_bits(column.method == ContactMethod::exact ? "contact" : "contact by dexels",
                     [&](const Device& device) {
                       gabarit::Setup setup;
                       if (column.motion == Motion::sweep) setup.height_band = {1, 6};
                       return vertical_cylinder_contact(Scene(model, device), setup, column);
                     });
  }
}

INSTANTIATE_TEST_SUITE_P(EveryModel, SameFields, testing::ValuesIn(kinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace gabarit
