// The walk over the tree, written once; what is looked for is a query:
//   float lower_bounds(const BvhNode&, float (&lower)[8])  fills a lower bound a child, infinity to skip it
//   float limit() const                                    children whose bound is above it are skipped
//   void visit(const Primitive&)                           decides one primitive, may lower the limit
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
    if (entry.child & leaf_flag) {
      const std::uint32_t first = entry.child & 0x0fffffffU;
      const std::uint32_t last = first + (entry.child >> 28 & 7U);
      for (std::uint32_t i = first; i <= last; ++i) query.visit(tree.primitives[i]);
      continue;
    }
    const BvhNode& node = tree.nodes[entry.child];
    float lower[tree_width];
    query.lower_bounds(node, lower);
    const int base = top;
    const float limit = query.limit();
    for (int i = 0; i < tree_width; ++i) {
      if (!(lower[i] <= limit) || node.child[i] == no_child) continue;
      int k = top++;
      for (; k > base && stack[k - 1].bound < lower[i]; --k) stack[k] = stack[k - 1];
      stack[k] = {lower[i], node.child[i]};
    }
  }
}

}  // namespace gabarit
