// The upper part of a tree, built where kernels run: ranges are cut in two round by round, all of a round at
// once, down to what fits into the leaves of one node.
#pragma once

#include <optional>

#include "gpu/buffer.h"
#include "gpu/bvh_bottom.h"

namespace gabarit {

struct BinaryNode {
  BuildRange range;
  std::uint32_t left = no_child;  // the right child is the next; none: the range has no more than bottom_size
};

struct BinaryTree {
  Buffer<BinaryNode> nodes;      // the first is the root
  Buffer<BoxedPrimitive> boxes;  // in the order of the tree, not yet within its last ranges
};

// The cuts of bvh_split.cpp. Nothing when a range can only be halved by count, as where many boxes have the
// same centre: such surfaces are for the CPU.
std::optional<BinaryTree> binary_tree(const Device& device, Buffer<BoxedPrimitive> boxes, const Box3f& box);

}  // namespace gabarit
