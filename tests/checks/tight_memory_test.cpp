// Contacts on devices whose memory does not hold the model: in parts, with the same bits, and without
// beginning again on the CPU.
#include <gtest/gtest.h>

#include "checks/vertical_cylinder_contact.h"
#include "cli/on_device.h"
#include "tests/block_solid.h"
#include "tests/checks/field_bits.h"
#include "tests/checks/wall_fields.h"
#include "tests/gpu/other_devices.h"

namespace gabarit {
namespace {

constexpr std::size_t kibibyte = 1024;
// That all of these contacts get by with, whatever the model; docs/cuda.md names it.
constexpr std::size_t enough = 256 * kibibyte;

Model model_of(const shapes::BlockSolid& solid, double facets) {
  Model model;
  model.mesh = shapes::with_facets(solid, facets);
  model.sag = 0.1;
  return model;
}

// Islands, some of which a column reaches.
shapes::Triangles islands() {
  shapes::Triangles all;
  for (int i = 0; i < 24; ++i) {
    const double x = i % 6 * 115.0, y = i / 6 * 97.0;
    all = shapes::joined(all, shapes::moved(shapes::sphere(9 + i % 5, 12, 16), {x, y, 20}));
  }
  return all;
}

struct Kind {
  const char* name;
  Model (*make)();
};

const std::vector<Kind> kinds{
    {"islands", [] { return shapes::model(islands()); }},
    {"turned_box",
     [] {
       return shapes::model(shapes::rotated(shapes::gridded_box({0, 0, 0}, {300, 80, 40}, 4),
                                            normalized(Vec3d{1, 2, 9}), 0.7));
     }},
    {"casting", [] { return model_of(shapes::ribbed_casting(), 20'000); }},
};

const std::vector<VerticalCylinder> columns{
    {.radius = 80, .motion = Motion::any},
    {.radius = 60, .motion = Motion::sweep},
    {.radius = 80, .motion = Motion::forward, .method = ContactMethod::dexel, .spacing = 2}};

struct Outcome {
  Bits bits;
  int restarts = 0;
};

Outcome contact_of(const Model& model, const VerticalCylinder& column, const Device& device) {
  Outcome outcome;
  const auto work = [&](const Device& where) {
    gabarit::Setup setup;
    if (column.motion == Motion::sweep) setup.height_band = {5, 30};
    return bits_of(vertical_cylinder_contact(Scene(model, where), setup, column));
  };
  outcome.bits = on_device(device, false, work, [&](const std::string&) { ++outcome.restarts; });
  return outcome;
}

class OnModels : public testing::TestWithParam<Kind> {};

TEST_P(OnModels, a_contact_is_the_same_bits_and_never_begun_again) {
  const Model model = GetParam().make();
  for (const VerticalCylinder& column : columns) {
    const Outcome expected = contact_of(model, column, plain_cpu);
    for (const std::size_t room : {65536 * kibibyte, 1024 * kibibyte, enough}) {
      MemoryLimit limit(room);
      const Outcome tight = contact_of(model, column, Device::simulated(2, &limit));
      EXPECT_TRUE(expected.bits == tight.bits) << room;
      EXPECT_EQ(tight.restarts, 0) << room;
      EXPECT_TRUE(limit.take(room)) << "memory was not given back";
    }
  }
}

TEST(TightMemory, a_contact_of_200_000_facets_needs_no_more_than_a_small_one) {
  const Model model = model_of(shapes::ribbed_casting(), 200'000);
  for (const VerticalCylinder& column : {columns[0], columns[2]}) {
    MemoryLimit limit(enough);
    const Outcome tight = contact_of(model, column, Device::simulated(2, &limit));
    EXPECT_TRUE(contact_of(model, column, Device::cpu(2)).bits == tight.bits);
    EXPECT_EQ(tight.restarts, 0);
  }
}

TEST_P(OnModels, without_room_for_a_part_a_contact_is_begun_again_on_the_cpu) {
  const Model model = GetParam().make();
  MemoryLimit limit(4 * kibibyte);
  const Outcome tight = contact_of(model, columns[0], Device::simulated(2, &limit));
  EXPECT_TRUE(contact_of(model, columns[0], plain_cpu).bits == tight.bits);
  EXPECT_EQ(tight.restarts, 1);
}

INSTANTIATE_TEST_SUITE_P(TightMemory, OnModels, testing::ValuesIn(kinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace gabarit
