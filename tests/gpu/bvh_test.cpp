#include "gpu/bvh.h"

#include <gtest/gtest.h>

#include "gpu/box.h"
#include "tests/gpu/tree_surfaces.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

bool holds(const Box3f& box, const Vec3d& p) {
  for (int k = 0; k < 3; ++k)
    if (p[k] < static_cast<double>(box.min[k]) || p[k] > static_cast<double>(box.max[k])) return false;
  return true;
}

template <class Boxes>
Box3f box_of(const Boxes& boxes, int i) {
  return {{boxes.low(0, i), boxes.low(1, i), boxes.low(2, i)},
          {boxes.high(0, i), boxes.high(1, i), boxes.high(2, i)}};
}

// How often each primitive is met below a child whose boxes all hold it, by its place in the order.
void meet(const BvhView& tree, std::uint32_t child, const std::vector<Box3f>& around, std::vector<int>& met) {
  if ((child & leaf_flag) == 0) {
    const BvhNode& node = tree.nodes[child];
    for (int i = 0; i < tree_width; ++i) {
      if (node.child[i] == no_child) continue;
      std::vector<Box3f> closer = around;
      closer.push_back(box_of(node, i));
      meet(tree, node.child[i], closer, met);
    }
    return;
  }
  const BvhLeaf& leaf = tree.leaves[child & ~leaf_flag];
  ASSERT_LE(leaf.count, static_cast<std::uint32_t>(leaf_width));
  for (std::uint32_t i = 0; i < leaf.count; ++i) {
    const Primitive& p = tree.primitives[leaf.first + i];
    bool inside = true;
    for (int c = 0; c < (p.is_facet() ? 3 : 2); ++c) {
      const Vec3d at = tree.corner(p, c) - tree.origin;
      inside = inside && holds(box_of(leaf, static_cast<int>(i)), at);
      for (const Box3f& box : around) inside = inside && holds(box, at);
    }
    met[leaf.first + i] += inside ? 1 : 100;
  }
}

void expect_sound(const FacetSurface& surface, int threads = 1) {
  const Bvh tree(Device::cpu(threads), surface);
  std::vector<int> met(surface.primitives.size());
  meet(tree.view(), 0, {}, met);
  EXPECT_EQ(met, std::vector<int>(met.size(), 1));
}

TEST(Bvh, every_primitive_lies_in_one_leaf_and_in_all_boxes_on_the_way) {
  for (const std::uint32_t count : {1U, 2U, 8U, 9U, 48U, 49U, 65U, 500U, 3000U})
    expect_sound(random_surface(count, count % 2 == 0 ? 0.1 : 20, count));
}

TEST(Bvh, primitives_in_the_same_place_are_kept_apart_by_count) {
  FacetSurface surface = random_surface(1, 1, 1);
  surface.primitives.assign(1000, surface.primitives.front());
  expect_sound(surface);
}

TEST(Bvh, cuts_shared_between_threads_lose_nothing) {
  expect_sound(surface_of(shapes::mesh(shapes::sphere(10, 150, 300))), 3);
}

TEST(Bvh, any_number_of_threads_makes_the_same_tree) {
  const FacetSurface surface = surface_of(shapes::mesh(shapes::sphere(10, 150, 300)));
  const Bvh one(Device::cpu(1), surface), three(Device::cpu(3), surface);
  EXPECT_EQ(one.order(), three.order());
  EXPECT_EQ(one.bytes(), three.bytes());
}

TEST(Bvh, a_facet_of_a_closed_mesh_takes_no_more_than_80_bytes) {
  const TriangleMesh mesh = shapes::mesh(shapes::sphere(10, 100, 200));
  const Bvh tree(Device::cpu(1), surface_of(mesh));
  EXPECT_LE(tree.bytes(), 80 * mesh.facet_count());
}

}  // namespace
}  // namespace gabarit
