// The walk over the tree, written once; what is looked for is a query:
//   unsigned within(boxes, float (&lower)[8])  boxes of a node's children or a leaf's primitives: fills a
//                                              lower bound each, bit i of the result: it is within the limit
//   float limit() const                        finite; what has a bound above it is skipped
//   void visit(const Primitive&)               decides one primitive, may lower the limit
#pragma once

#include "gpu/bvh.h"

namespace gabarit {

// Nearest bound first. Bounds are kept with the children and looked at again when their turn comes, as the
// limit has shrunk by then.
template <class Query>
GABARIT_HD void traverse(const BvhView& tree, Query& query) {
  struct Entry {
    float bound;
    std::uint32_t child;
  };
  // The tree is at most 14 + 11 levels deep (bvh_split.cpp), each leaves at most seven entries behind.
  Entry stack[tree_width * 32];
  int top = 0;
  if (tree.nodes.size == 0) return;
  stack[top++] = {0.0F, 0};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (!(entry.bound <= query.limit())) continue;
    float lower[tree_width];
    if (entry.child & leaf_flag) {
      const BvhLeaf& leaf = tree.leaves[entry.child & ~leaf_flag];
      const unsigned all = (1U << leaf.count) - 1;
      for (unsigned mask = query.within(boxes_of(leaf), lower) & all; mask != 0; mask &= mask - 1) {
        const int i = lowest_bit(mask);
        if (lower[i] <= query.limit()) query.visit(tree.primitives[leaf.first + static_cast<unsigned>(i)]);
      }
      continue;
    }
    const BvhNode& node = tree.nodes[entry.child];
    const int base = top;
    for (unsigned mask = query.within(node, lower); mask != 0; mask &= mask - 1) {
      const int i = lowest_bit(mask);
      int k = top++;
      for (; k > base && stack[k - 1].bound < lower[i]; --k) stack[k] = stack[k - 1];
      stack[k] = {lower[i], node.child[i]};
    }
  }
}

}  // namespace gabarit
