// The walk over the tree, written once; what is looked for is a query:
//   void within(boxes, EightFloats& lower)  a lower bound for each of a node's children or a leaf's
//   primitives float limit() const                     finite; what has a bound above it is skipped void
//   visit(const Primitive&)            decides one primitive, may lower the limit
#pragma once

#include "gpu/bvh.h"
#include "gpu/bvh_limits.h"
#include "gpu/no_greater.h"

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

GABARIT_HD inline float one_of(const EightFloats& values, int at) {
  if constexpr (!on_gpu) return values[at];
  float value = values[0];
  GABARIT_UNROLL
  for (int i = 1; i < tree_width; ++i) value = i == at ? values[i] : value;
  return value;
}

// Nearest bound first, unless a visit costs less than the order.
template <VectorSet set, class Query>
GABARIT_HD inline void visit_leaf(const BvhView& tree, const BvhLeaf& leaf, Query& query) {
  EightFloats lower;
  query.within(leaf, lower);
  unsigned mask = no_greater<set>(lower, query.limit()) & ((1U << leaf.count) - 1);
  while (mask != 0) {
    int next = lowest_bit(mask);
    if constexpr (!requires { typename Query::cheap_to_visit; }) {
      for (unsigned rest = mask & (mask - 1); rest != 0; rest &= rest - 1)
        if (one_of(lower, lowest_bit(rest)) < one_of(lower, next)) next = lowest_bit(rest);
    }
    mask &= ~(1U << next);
    if (one_of(lower, next) <= query.limit())
      query.visit(tree.primitives[leaf.first + static_cast<unsigned>(next)]);
  }
}

struct TreeEntry {
  float bound;
  std::uint32_t child;
};

// The children within the limit, in order on the stack from `base` on, but for the nearest, which becomes
// `now`: it needs no turn. Returns the new top, or -1 when there is no child.
template <VectorSet set, class Query>
GABARIT_HD inline int sort_children(const BvhNode& node, Query& query, TreeEntry& now, TreeEntry* stack,
                                    int base) {
  EightFloats lower;
  query.within(node, lower);
  int top = base;
  bool first = true;
  for_each_bit(no_greater<set>(lower, query.limit()), [&](int i) {
    TreeEntry later{lower[i], node.child[i]};
    if (first || later.bound <= now.bound) {
      const TreeEntry other = now;
      now = later, later = other;
      if (first) return void(first = false);
    }
    int k = top++;
    for (; k > base && stack[k - 1].bound < later.bound; --k) stack[k] = stack[k - 1];
    stack[k] = later;
  });
  return first ? -1 : top;
}

// Nearest bound first. Bounds are kept with the children and looked at again when their turn comes, as the
// limit has shrunk by then.
template <VectorSet set = VectorSet::portable, class Query>
GABARIT_HD void traverse(const BvhView& tree, Query& query) {
  // Each level leaves at most seven entries behind, the last all eight.
  TreeEntry stack[(greatest_depth - 1) * (tree_width - 1) + tree_width];
  int top = 0;
  if (tree.nodes.size == 0) return;
  TreeEntry now{0.0F, 0};
  while (true) {
    if (now.child & leaf_flag) {
      visit_leaf<set>(tree, tree.leaves[now.child & ~leaf_flag], query);
    } else {
      const int filled = sort_children<set>(tree.nodes[now.child], query, now, stack, top);
      if (filled >= 0) {
        top = filled;
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
