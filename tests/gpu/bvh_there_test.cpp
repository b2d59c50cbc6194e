// Trees built where kernels run against those of the CPU. The simulated device can be looked into.
#include "gpu/bvh_there.h"

#include <random>

#include <gtest/gtest.h>

#include "gpu/bumpy_ball.h"
#include "gpu/simulated_memory.h"

namespace gabarit {
namespace {

void expect_equal_leaves(const BvhLeaf& a, const BvhLeaf& b) {
  ASSERT_EQ(a.first, b.first);
  ASSERT_EQ(a.count, b.count);
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(a.from[k], b.from[k]);
    ASSERT_EQ(a.step[k], b.step[k]);
  }
  for (std::uint32_t i = 0; i < a.count; ++i) {
    ASSERT_EQ(a.lo[i], b.lo[i]);
    ASSERT_EQ(a.hi[i], b.hi[i]);
  }
}

// Everything but the numbers of nodes and leaves.
void expect_equal_nodes(const BvhView& a, const BvhView& b, std::uint32_t i, std::uint32_t k) {
  const BvhNode& n = a.nodes[i];
  const BvhNode& m = b.nodes[k];
  for (int c = 0; c < tree_width; ++c) {
    ASSERT_EQ(n.child[c] == no_child, m.child[c] == no_child);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(n.lo[axis][c], m.lo[axis][c]);
      ASSERT_EQ(n.hi[axis][c], m.hi[axis][c]);
      ASSERT_EQ(n.axis[axis][c], m.axis[axis][c]);
    }
    ASSERT_EQ(n.offset[c], m.offset[c]);
    ASSERT_EQ(n.cone[c], m.cone[c]);
    if (n.child[c] == no_child) continue;
    ASSERT_EQ(n.child[c] & leaf_flag, m.child[c] & leaf_flag);
    if ((n.child[c] & leaf_flag) != 0)
      expect_equal_leaves(a.leaves[n.child[c] & ~leaf_flag], b.leaves[m.child[c] & ~leaf_flag]);
    else
      expect_equal_nodes(a, b, n.child[c], m.child[c]);
    if (testing::Test::HasFatalFailure()) return;
  }
}

void expect_equal_trees(const Bvh& one, const Bvh& other) {
  const SimulatedAccess access;
  const BvhView a = one.view(), b = other.view();
  ASSERT_EQ(a.nodes.size, b.nodes.size);
  ASSERT_EQ(a.leaves.size, b.leaves.size);
  ASSERT_EQ(a.points.size, b.points.size);
  ASSERT_EQ(a.reach, b.reach);
  ASSERT_EQ(a.greatest_sag, b.greatest_sag);
  ASSERT_EQ(one.order(), other.order());
  for (std::int64_t i = 0; i < a.points.size; ++i) ASSERT_EQ(a.points[i], b.points[i]);
  for (std::int64_t i = 0; i < a.primitives.size; ++i) {
    ASSERT_EQ(a.primitives[i].corner, b.primitives[i].corner);
    ASSERT_EQ(a.primitives[i].sag, b.primitives[i].sag);
  }
  if (a.nodes.size > 0) expect_equal_nodes(a, b, 0, 0);
}

void expect_the_same_tree_there(const FacetSurface& surface) {
  expect_equal_trees(Bvh(Device::cpu(1), surface), Bvh(Device::simulated(2), surface));
}

TEST(BvhThere, a_closed_surface_of_any_size_has_the_tree_of_the_cpu) {
  for (const int rings : {2, 3, 4, 7, 30, 90})
    expect_the_same_tree_there(bumpy_ball(rings, 3 + rings, 10, 0.2, {900, -40, 7}));
}

// Facets of all sizes with sags, edges and vertices among them.
FacetSurface random_surface(std::uint32_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(-100, 100), offset(-1, 1);
  FacetSurface surface;
  surface.fan_first = {0, 1};
  surface.fan_directions = {{0, 0, 1}};
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3d a{anywhere(random), anywhere(random), anywhere(random)};
    const double size = i % 7 == 0 ? 50 : 0.5;
    for (int k = 0; k < 3; ++k)
      surface.points.push_back(a + Vec3d{offset(random), offset(random), offset(random)} * size);
    const Vec3d n = normalized(Vec3d{offset(random), offset(random), 1.5});
    Primitive p{{3 * i, 3 * i + 1, 3 * i + 2}, i, {}, static_cast<float>(i % 3) * 0.1F};
    if (i % 5 == 0)
      p.corner[2] = 0;
    else
      p.normal = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
    if (i % 10 == 0) p.corner[1] = p.corner[0];
    surface.primitives.push_back(p);
  }
  return surface;
}

TEST(BvhThere, facets_edges_and_vertices_in_any_place_have_the_tree_of_the_cpu) {
  for (const std::uint32_t count : {1U, 6U, 7U, 8U, 9U, 47U, 48U, 49U, 100U, 1000U, 20'000U})
    expect_the_same_tree_there(random_surface(count, count));
}

TEST(BvhThere, edges_and_vertices_that_balls_can_touch_have_the_tree_of_the_cpu) {
  FacetSurface surface = random_surface(3000, 11);
  std::mt19937 random(12);
  std::normal_distribution<float> any;
  for (Primitive& p : surface.primitives) {
    if (p.is_facet()) continue;
    p.corner[2] = static_cast<std::uint32_t>(surface.fan_first.size() - 1);
    for (int k = 0; k < 5; ++k) {
      const Vec3d w = normalized(Vec3d{any(random), any(random), 0.5 + std::fabs(any(random))});
      surface.fan_directions.push_back(
          {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z)});
    }
    surface.fan_first.push_back(static_cast<std::uint32_t>(surface.fan_directions.size()));
  }
  expect_the_same_tree_there(surface);
}

TEST(BvhThere, threads_make_no_difference) {
  const FacetSurface surface = random_surface(5000, 1);
  expect_equal_trees(Bvh(Device::simulated(1), surface), Bvh(Device::simulated(4), surface));
}

TEST(BvhThere, a_shuffled_surface_has_the_tree_of_the_cpu) {
  FacetSurface surface = bumpy_ball(40, 60, 10, 0.2);
  std::shuffle(surface.primitives.begin(), surface.primitives.end(), std::mt19937(5));
  expect_the_same_tree_there(surface);
}

FacetSurface copies(int count) {
  FacetSurface surface = bumpy_ball(4, 6, 10, 0.2);
  const std::vector<Primitive> once = surface.primitives;
  for (int i = 1; i < count; ++i)
    surface.primitives.insert(surface.primitives.end(), once.begin(), once.end());
  for (std::uint32_t i = 0; i < surface.primitives.size(); ++i) surface.primitives[i].id = i;
  return surface;
}

TEST(BvhThere, some_copies_of_every_facet_are_cut_and_too_many_are_left_to_the_cpu) {
  for (const int count : {2, 9, 40, 60, 200}) expect_the_same_tree_there(copies(count));
  EXPECT_TRUE(build_there(Device::simulated(1), copies(40), {}, {}).has_value());
  EXPECT_FALSE(build_there(Device::simulated(1), copies(60), {}, {}).has_value());
}

// Each nearer to the middle by a factor: cuts take few off at a time.
TEST(BvhThere, a_crowd_that_thins_out_has_the_tree_of_the_cpu) {
  FacetSurface surface;
  double x = 1000;
  for (std::uint32_t i = 0; i < 3000; ++i, x *= 0.99) {
    surface.points.insert(surface.points.end(), {{x, 0, 0}, {x * 1.005, 0, 0}, {x, x * 0.005, 0}});
    surface.primitives.push_back({{3 * i, 3 * i + 1, 3 * i + 2}, i, {0, 0, 1}, 0});
  }
  expect_the_same_tree_there(surface);
}

TEST(BvhThere, nothing_has_an_empty_tree) {
  const Bvh tree(Device::simulated(1), FacetSurface{});
  EXPECT_EQ(tree.view().nodes.size, 0);
}

}  // namespace
}  // namespace gabarit
