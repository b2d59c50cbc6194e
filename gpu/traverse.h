// The walk over the tree, written once; what is looked for is a query:
//   unsigned within(boxes, float (&lower)[8])  boxes of a node's children or a leaf's primitives: fills a
//                                              lower bound each, bit i of the result: it is within the limit
//   float limit() const                        finite; what has a bound above it is skipped
//   void visit(const Primitive&)               decides one primitive, may lower the limit
#pragma once

#include "gpu/bvh.h"
#include "gpu/bvh_limits.h"

namespace gabarit {

// Calls use(i) for the bits that are set among the lowest eight, lowest first. A GPU asks for each: indices
// that it knows when it compiles leave small arrays in registers.
template <class Use>
GABARIT_HD void for_each_bit(unsigned bits, Use&& use) {
  if constexpr (on_gpu) {
    GABARIT_UNROLL
    for (int i = 0; i < tree_width; ++i)
      if ((bits >> i & 1U) != 0) use(i);
  } else {
    for (; bits != 0; bits &= bits - 1) use(lowest_bit(bits));
  }
}

GABARIT_HD inline float one_of(const float (&values)[tree_width], int at) {
  if constexpr (!on_gpu) return values[at];
  float value = values[0];
  GABARIT_UNROLL
  for (int i = 1; i < tree_width; ++i) value = i == at ? values[i] : value;
  return value;
}

// Nearest bound first. Bounds are kept with the children and looked at again when their turn comes, as the
// limit has shrunk by then.
template <class Query>
GABARIT_HD void traverse(const BvhView& tree, Query& query) {
  struct Entry {
    float bound;
    std::uint32_t child;
  };
  // Each level leaves at most seven entries behind, the last all eight.
  Entry stack[(greatest_depth - 1) * (tree_width - 1) + tree_width];
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
        if (one_of(lower, i) <= query.limit())
          query.visit(tree.primitives[leaf.first + static_cast<unsigned>(i)]);
      }
      continue;
    }
    const BvhNode& node = tree.nodes[entry.child];
    const int base = top;
    for_each_bit(query.within(node, lower), [&](int i) {
      int k = top++;
      for (; k > base && stack[k - 1].bound < lower[i]; --k) stack[k] = stack[k - 1];
      stack[k] = {lower[i], node.child[i]};
    });
  }
}

}  // namespace gabarit
