#include "gpu/rolling_depth.h"

#include <random>

#include <gtest/gtest.h>

#include "gpu/segment_grid.h"
#include "tests/gpu/other_devices.h"

namespace gabarit {
namespace {

using Segments = std::vector<Segment2>;

std::vector<float> depths(const Segments& segments, const Segments& centres, const RollingDisk& disk,
                          const Device& device = Device::cpu(1), double square = 3) {
  const SegmentGrid grid(segments, square);
  return RollingDepth(device, grid.lists(), segments).along(centres, disk);
}

TEST(RollingDepth, of_a_wall_beside_a_straight_way_is_its_distance_less_the_radius) {
  const Segments walls{
      {{0, 0}, {100, 0}}, {{0, -0.05}, {100, -0.05}}, {{0, -1}, {100, -1}}, {{200, 0}, {300, 0}}};
  for (const Device& device : {Device::cpu(1), Device::simulated(2)}) {
    const std::vector<float> found = depths(walls, {{{-20, 15}, {120, 15}}}, {15, 0.1, 0}, device);
    EXPECT_EQ(found[0], 0.0F);
    EXPECT_NEAR(found[1], 0.05, 1e-6);
    EXPECT_TRUE(std::isinf(found[2]));
    EXPECT_TRUE(std::isinf(found[3]));
  }
}

// Segments that a disk of radius 20 around any centre does not overlap.
struct Scene {
  Segments segments, centres;
};

Scene random_scene(unsigned seed, bool places, std::size_t segments = 300, int centres = 40) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(-60, 60), step(-15, 15);
  Scene scene;
  for (int i = 0; i < centres; ++i) {
    const Point2 a{anywhere(random), anywhere(random)};
    scene.centres.push_back({a, places || i % 2 == 0 ? a : a + Point2{step(random), step(random)}});
  }
  while (scene.segments.size() < segments) {
    const Point2 a{2 * anywhere(random), 2 * anywhere(random)};
    const Segment2 s{a, a + Point2{step(random), step(random)}};
    double least = 1e300;
    for (const Segment2& c : scene.centres)
      least = std::min(least, segment_distance(c.from, c.to, s.from, s.to));
    if (least >= 20) scene.segments.push_back(s);
  }
  return scene;
}

TEST(RollingDepth, is_the_distance_to_the_nearest_centre_by_a_look_at_all) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Scene scene = random_scene(seed, false);
    for (const double tolerance : {0.1, 5.0}) {
      const std::vector<float> found = depths(scene.segments, scene.centres, {20, tolerance, 0});
      for (std::size_t i = 0; i < scene.segments.size(); ++i) {
        const Segment2& s = scene.segments[i];
        double least = 1e300;
        for (const Segment2& c : scene.centres)
          least = std::min(least, segment_distance(c.from, c.to, s.from, s.to));
        if (least <= 20 + tolerance)
          EXPECT_EQ(found[i], static_cast<float>(least - 20));
        else
          EXPECT_TRUE(std::isinf(found[i]));
      }
    }
  }
}

TEST(RollingDepth, is_the_same_bits_on_every_device_and_for_squares_of_any_size) {
  for (const bool places : {false, true}) {
    const Scene scene = random_scene(4, places);
    const RollingDisk disk{20, 2, places ? 1.5 : 0.0};
    const std::vector<float> expected = depths(scene.segments, scene.centres, disk, plain_cpu);
    EXPECT_TRUE(std::any_of(expected.begin(), expected.end(), [](float d) { return std::isfinite(d); }));
    for (const auto& [name, device] : other_devices())
      EXPECT_EQ(expected, depths(scene.segments, scene.centres, disk, device)) << name;
    for (const double square : {0.5, 11.0, 400.0})
      EXPECT_EQ(expected, depths(scene.segments, scene.centres, disk, plain_cpu, square));
  }
}

TEST(RollingDepth, is_the_same_bits_in_batches_of_sides_and_centres) {
  for (const bool places : {false, true}) {
    const Scene scene = random_scene(6, places, 2000, 300);
    const RollingDisk disk{20, 2, places ? 1.5 : 0.0};
    const std::vector<float> expected = depths(scene.segments, scene.centres, disk, plain_cpu);
    for (const std::size_t room : {400'000U, 100'000U, 60'000U}) {
      MemoryLimit limit(room);
      EXPECT_EQ(expected, depths(scene.segments, scene.centres, disk, Device::simulated(1, &limit))) << room;
    }
  }
}

// Which of two walls it is taken to touch must not hang on the batch that comes first.
TEST(RollingDepth, of_a_place_that_touches_two_walls_does_not_depend_on_batches) {
  Segments walls{{{0, 20}, {50, 20}}, {{0, 21}, {90, 21}}};
  for (int i = 0; i < 2000; ++i) walls.push_back({{200, 0.01 * i}, {210, 0.01 * i}});
  walls.push_back({{0, -20}, {50, -20}});
  walls.push_back({{0, -21}, {90, -21}});
  const Segments place{{{25, 0}, {25, 0}}};
  const std::vector<float> expected = depths(walls, place, {20, 0.5, 3}, plain_cpu);
  EXPECT_NE(std::isinf(expected[1]), std::isinf(expected.back()));
  MemoryLimit limit(60'000);
  EXPECT_EQ(expected, depths(walls, place, {20, 0.5, 3}, Device::simulated(1, &limit)));
}

TEST(RollingDepth, moves_with_the_plan_and_does_not_depend_on_the_order) {
  Scene scene = random_scene(5, false);
  const std::vector<float> before = depths(scene.segments, scene.centres, {20, 3, 0});
  const auto turn = [](Point2 p) { return Point2{0.6 * p.x - 0.8 * p.y + 4000, 0.8 * p.x + 0.6 * p.y - 70}; };
  for (Segments* all : {&scene.segments, &scene.centres}) {
    std::reverse(all->begin(), all->end());
    for (Segment2& s : *all) s = {turn(s.to), turn(s.from)};
  }
  const std::vector<float> after = depths(scene.segments, scene.centres, {20, 3, 0});
  for (std::size_t i = 0; i < before.size(); ++i) {
    const float depth = after[before.size() - 1 - i];
    // Where the tolerance ends, rounding may tell either way.
    if (std::min(before[i], depth) > 2.999F) continue;
    EXPECT_NEAR(before[i], depth, 1e-5);
  }
}

TEST(RollingDepth, of_nothing_is_nothing_and_along_nothing_is_infinite) {
  for (const Device& device : {Device::cpu(1), Device::simulated(1)}) {
    EXPECT_TRUE(depths({}, {{{0, 0}, {1, 1}}}, {5, 1, 0}, device).empty());
    EXPECT_TRUE(std::isinf(depths({{{0, 0}, {1, 0}}}, {}, {5, 1, 0}, device)[0]));
  }
}

}  // namespace
}  // namespace gabarit
