// The ways of CUDA on the CPU: memory apart, batches, no short cuts.
#include <gtest/gtest.h>

#include "gpu/bumpy_ball.h"
#include "gpu/closest_point.h"
#include "gpu/device_error.h"
#include "gpu/maximal_sphere.h"
#include "gpu/ray_cast.h"

namespace gabarit {
namespace {

struct Answers {
  std::vector<SphereContact> spheres;
  std::vector<RayHit> hits;
  std::vector<ClosestPoint> closest;
};

Vec3d inwards(const Primitive& p) {
  return {-static_cast<double>(p.normal.x), -static_cast<double>(p.normal.y),
          -static_cast<double>(p.normal.z)};
}

Answers ask(const Bvh& tree, const FacetSurface& surface) {
  std::vector<SphereQuery> queries;
  std::vector<Ray> rays;
  std::vector<Vec3d> points;
  for (const Primitive& p : surface.primitives) {
    const Vec3d at =
        (surface.points[p.corner[0]] + surface.points[p.corner[1]] + surface.points[p.corner[2]]) / 3.0;
    queries.push_back({at, normalized(inwards(p)), p.id, 0.01F, 0, 0});
    rays.push_back({at, normalized(inwards(p)), p.id, 1e-6});
    points.push_back(at + 0.3 * inwards(p));
  }
  Answers answers{std::vector<SphereContact>(points.size()), std::vector<RayHit>(points.size()),
                  std::vector<ClosestPoint>(points.size())};
  maximal_spheres(tree, {.cos_separation = -0.5, .contact_floor = 1e-6}, queries, answers.spheres);
  cast_rays(tree, rays, answers.hits);
  closest_points(tree, points, answers.closest);
  return answers;
}

void expect_same(const Answers& a, const Answers& b) {
  for (std::size_t i = 0; i < a.spheres.size(); ++i) {
    EXPECT_EQ(a.spheres[i].radius, b.spheres[i].radius);
    EXPECT_EQ(a.spheres[i].lower, b.spheres[i].lower);
    EXPECT_EQ(a.spheres[i].upper, b.spheres[i].upper);
    EXPECT_EQ(a.spheres[i].contact, b.spheres[i].contact);
    EXPECT_EQ(a.spheres[i].primitive, b.spheres[i].primitive);
    EXPECT_EQ(a.hits[i].distance, b.hits[i].distance);
    EXPECT_EQ(a.hits[i].facet, b.hits[i].facet);
    EXPECT_EQ(a.closest[i].point, b.closest[i].point);
    EXPECT_EQ(a.closest[i].facet, b.closest[i].facet);
  }
}

TEST(SimulatedDevice, gives_the_bits_of_the_cpu) {
  for (const double bumps : {0.2, 0.0}) {
    const FacetSurface surface = bumpy_ball(30, 40, 10, bumps);
    expect_same(ask(Bvh(Device::cpu(1), surface), surface), ask(Bvh(Device::simulated(2), surface), surface));
  }
}

TEST(SimulatedDevice, queries_that_do_not_fit_go_in_batches_and_give_the_same_bits) {
  const FacetSurface surface = bumpy_ball(30, 40, 10, 0.2);
  const Answers all = ask(Bvh(Device::cpu(1), surface), surface);
  MemoryLimit limit(std::size_t{1} << 30);
  const Bvh tree(Device::simulated(1, &limit), surface);
  ASSERT_TRUE(limit.take((std::size_t{1} << 30) - tree.bytes() - 20'000));
  expect_same(all, ask(tree, surface));
}

TEST(SimulatedDevice, a_tree_that_it_has_no_room_to_build_is_built_by_the_cpu) {
  const FacetSurface surface = bumpy_ball(30, 40, 10, 0.2);
  const Bvh here(Device::cpu(1), surface);
  MemoryLimit limit(here.bytes() + 100);
  const Bvh there(Device::simulated(1, &limit), surface);
  EXPECT_EQ(here.order(), there.order());
  EXPECT_EQ(here.bytes(), there.bytes());
}

TEST(SimulatedDevice, a_tree_that_does_not_fit_is_out_of_memory) {
  MemoryLimit limit(10'000);
  EXPECT_THROW(Bvh(Device::simulated(1, &limit), bumpy_ball(30, 40, 10, 0)), OutOfDeviceMemory);
}

}  // namespace
}  // namespace gabarit
