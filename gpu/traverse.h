// The walk over the tree, written once; what is looked for is a query:
//   void within(boxes, EightFloats& lower)  a lower bound for each of a node's children or a leaf's
//   primitives float limit() const                     finite; what has a bound above it is skipped void
//   visit(const Primitive&)            decides one primitive, may lower the limit
#pragma once

#include "gpu/bvh.h"
#include "gpu/no_greater.h"

namespace gabarit {

// Nearest bound first, unless a visit costs less than the order.
template <VectorSet set, class Query>
GABARIT_HD inline void visit_leaf(const BvhView& tree, const BvhLeaf& leaf, Query& query) {
  EightFloats lower;
  query.within(leaf, lower);
  unsigned mask = no_greater<set>(lower, query.limit()) & ((1U << leaf.count) - 1);
  if constexpr (requires { Query::cheap_to_visit; }) {
    for (; mask != 0; mask &= mask - 1) {
      const int i = lowest_bit(mask);
      if (lower[i] <= query.limit()) query.visit(tree.primitives[leaf.first + static_cast<unsigned>(i)]);
    }
  }
  while (mask != 0) {
    int nearest = lowest_bit(mask);
    for (unsigned rest = mask & (mask - 1); rest != 0; rest &= rest - 1)
      if (lower[lowest_bit(rest)] < lower[nearest]) nearest = lowest_bit(rest);
    if (!(lower[nearest] <= query.limit())) return;
    mask &= ~(1U << nearest);
    query.visit(tree.primitives[leaf.first + static_cast<unsigned>(nearest)]);
  }
}

// Nearest bound first. Bounds are kept with the children and looked at again when their turn comes, as the
// limit has shrunk by then; the nearest child needs no turn.
template <VectorSet set = VectorSet::portable, class Query>
GABARIT_HD void traverse(const BvhView& tree, Query& query) {
  struct Entry {
    float bound;
    std::uint32_t child;
  };
  // The tree is at most 14 + 11 levels deep (bvh_split.cpp), each leaves at most seven entries behind.
  Entry stack[tree_width * 32];
  int top = 0;
  if (tree.nodes.size == 0) return;
  Entry now{0.0F, 0};
  while (true) {
    if (now.child & leaf_flag) {
      visit_leaf<set>(tree, tree.leaves[now.child & ~leaf_flag], query);
    } else {
      const BvhNode& node = tree.nodes[now.child];
      EightFloats lower;
      query.within(node, lower);
      unsigned mask = no_greater<set>(lower, query.limit());
      if (mask != 0) {
        const int base = top;
        int i = lowest_bit(mask);
        now = {lower[i], node.child[i]};
        for (mask &= mask - 1; mask != 0; mask &= mask - 1) {
          i = lowest_bit(mask);
          Entry later{lower[i], node.child[i]};
          if (later.bound <= now.bound) {
            const Entry other = now;
            now = later, later = other;
          }
          int k = top++;
          for (; k > base && stack[k - 1].bound < later.bound; --k) stack[k] = stack[k - 1];
          stack[k] = later;
        }
        continue;
      }
    }
    do {
      if (top == 0) return;
      now = stack[--top];
    } while (!(now.bound <= query.limit()));
  }
}

}  // namespace gabarit
