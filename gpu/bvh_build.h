// The steps of building a tree: split boxes into nodes, then give every child its cone and half-space.
#pragma once

#include <span>
#include <vector>

#include "gpu/box.h"
#include "gpu/bvh.h"

namespace gabarit {

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
void add_cones(const Device& device, const FacetSurface& surface, const Vec3d& origin, SplitTree& tree);

inline float round_down(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
inline float round_up(double x) { return -round_down(-x); }

}  // namespace gabarit
