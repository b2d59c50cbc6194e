// Nodes of eight from a binary tree, where kernels run.
#pragma once

#include <optional>

#include "gpu/binary_tree.h"

namespace gabarit {

struct WideTree {
  Buffer<BvhNode> nodes;  // level by level; cones are still to be added
  Buffer<BvhLeaf> leaves;
  Buffer<std::uint32_t> parent;  // by node: 8 * node above + child of it
  Buffer<std::uint32_t> home;    // by primitive in the order of the tree: 8 * node + child
};

constexpr std::uint32_t root_parent = 0xffffffffU;

// The nodes of bvh_split.cpp, numbered differently: the widest parts are opened first. Sorts the boxes within
// the last ranges. Nothing when the tree gets so deep that parts would have to be halved by count.
std::optional<WideTree> wide_tree(const Device& device, BinaryTree& binary);

}  // namespace gabarit
