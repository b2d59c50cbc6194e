// Puts the boxes of a leaf into its steps, rounded outwards.
#pragma once

#include "gpu/bvh_build.h"

namespace gabarit {

// The last step that is no further than x, and the first that is no nearer.
GABARIT_HD inline std::uint32_t step_below(const BvhLeaf& leaf, int axis, float x) {
  const float steps = leaf.step[axis] > 0 ? (x - leaf.from[axis]) / leaf.step[axis] : 0.0F;
  const auto whole = static_cast<std::uint32_t>(steps);
  std::uint32_t at = whole < BvhLeaf::most ? whole : BvhLeaf::most;
  while (at > 0 && leaf.place(axis, at) > x) --at;
  return at;
}
GABARIT_HD inline std::uint32_t step_above(const BvhLeaf& leaf, int axis, float x) {
  std::uint32_t at = step_below(leaf, axis, x);
  while (at < BvhLeaf::most && leaf.place(axis, at) < x) ++at;
  return at;
}

// Of `count` boxes, at most leaf_width; the first of the primitives is number `first`.
GABARIT_HD inline BvhLeaf pack(const BoxedPrimitive* boxes, std::uint32_t count, std::uint32_t first) {
  BvhLeaf leaf{};
  leaf.first = first;
  leaf.count = count;
  Box3f box;
  for (std::uint32_t i = 0; i < count; ++i) box.add(boxes[i].box);
  for (int k = 0; k < 3; ++k) {
    leaf.from[k] = box.min[k];
    leaf.step[k] = (box.max[k] - box.min[k]) / static_cast<float>(BvhLeaf::most);
    while (leaf.place(k, BvhLeaf::most) < box.max[k]) leaf.step[k] = next_above(leaf.step[k]);
    for (std::uint32_t i = 0; i < count; ++i) {
      leaf.lo[i] |= step_below(leaf, k, boxes[i].box.min[k]) << BvhLeaf::bits * k;
      leaf.hi[i] |= step_above(leaf, k, boxes[i].box.max[k]) << BvhLeaf::bits * k;
    }
  }
  return leaf;
}

}  // namespace gabarit
