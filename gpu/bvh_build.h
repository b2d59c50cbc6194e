// The steps of building a tree: split boxes into nodes, then give every child its cone and half-space.
#pragma once

#include <bit>
#include <span>
#include <vector>

#include "gpu/box.h"
#include "gpu/bvh.h"

namespace gabarit {

// Of absent children only.
GABARIT_HD inline BvhNode empty_node() {
  BvhNode node{};
  for (int i = 0; i < tree_width; ++i) {
    for (int k = 0; k < 3; ++k) {
      node.lo[k][i] = std::numeric_limits<float>::infinity();
      node.hi[k][i] = std::numeric_limits<float>::infinity();
    }
    node.child[i] = no_child;
  }
  return node;
}

struct ContactCap;

// A primitive's box relative to the origin of the tree, rounded outwards.
struct BoxedPrimitive {
  Box3f box;
  std::uint32_t primitive = 0;
};

// Which primitives lie below a child, as a run of the final order.
struct PrimitiveRange {
  std::uint32_t begin = 0, end = 0;
};

struct SplitTree {
  std::vector<BvhNode> nodes;
  std::vector<BvhLeaf> leaves;
  std::vector<std::array<PrimitiveRange, tree_width>> ranges;  // one a node
};

// A leaf of at most leaf_width primitives, the first of which is number `first`.
BvhLeaf packed(std::span<const BoxedPrimitive> boxes, std::uint32_t first);

// Puts the boxes into the order of the tree.
SplitTree split_into_nodes(const Device& device, std::vector<BoxedPrimitive>& boxes);

// Fills axis, offset and cone of every child. `surface.primitives` must be in the order of the tree.
void add_cones(const Device& device, const FacetSurface& surface, const std::vector<ContactCap>& caps,
               const Vec3d& origin, SplitTree& tree);

GABARIT_HD inline float next_below(float x) {
  if (x == 0) return -std::numeric_limits<float>::denorm_min();
  const auto bits = std::bit_cast<std::uint32_t>(x);
  return std::bit_cast<float>(x > 0 ? bits - 1 : bits + 1);
}
GABARIT_HD inline float next_above(float x) { return -next_below(-x); }
GABARIT_HD inline float round_down(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) > x ? next_below(f) : f;
}
GABARIT_HD inline float round_up(double x) { return -round_down(-x); }

// `number`: of the primitive.
GABARIT_HD inline BoxedPrimitive boxed_primitive(const Primitive& p, const Vec3d* points, const Vec3d& origin,
                                                 std::uint32_t number) {
  Box3d box;
  for (std::size_t c = 0; c < (p.is_facet() ? 3U : 2U); ++c) box.add(points[p.corner[c]] - origin);
  const auto s = static_cast<double>(p.sag);
  return {{{round_down(box.min.x - s), round_down(box.min.y - s), round_down(box.min.z - s)},
           {round_up(box.max.x + s), round_up(box.max.y + s), round_up(box.max.z + s)}},
          number};
}

}  // namespace gabarit
