#include "gpu/bvh_leaf.h"

#include <algorithm>
#include <cmath>

#include "gpu/bvh_build.h"

namespace gabarit {
namespace {

Box3f box_of(std::span<const BoxedPrimitive> boxes) {
  Box3f box;
  for (const BoxedPrimitive& b : boxes) box.add(b.box);
  return box;
}

// The last step that is no further than x, and the first that is no nearer.
std::uint32_t step_below(const BvhLeaf& leaf, int axis, float x) {
  const float steps = leaf.step[axis] > 0 ? (x - leaf.from[axis]) / leaf.step[axis] : 0.0F;
  std::uint32_t at = std::min(static_cast<std::uint32_t>(steps), BvhLeaf::most);
  while (at > 0 && leaf.place(axis, at) > x) --at;
  return at;
}
std::uint32_t step_above(const BvhLeaf& leaf, int axis, float x) {
  std::uint32_t at = step_below(leaf, axis, x);
  while (at < BvhLeaf::most && leaf.place(axis, at) < x) ++at;
  return at;
}

}  // namespace

BvhLeaf packed(std::span<const BoxedPrimitive> boxes, std::uint32_t first) {
  BvhLeaf leaf{};
  leaf.first = first;
  leaf.count = static_cast<std::uint32_t>(boxes.size());
  const Box3f box = box_of(boxes);
  for (int k = 0; k < 3; ++k) {
    leaf.from[k] = box.min[k];
    leaf.step[k] = (box.max[k] - box.min[k]) / static_cast<float>(BvhLeaf::most);
    while (leaf.place(k, BvhLeaf::most) < box.max[k])
      leaf.step[k] = std::nextafter(leaf.step[k], std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      leaf.lo[i] |= step_below(leaf, k, boxes[i].box.min[k]) << BvhLeaf::bits * k;
      leaf.hi[i] |= step_above(leaf, k, boxes[i].box.max[k]) << BvhLeaf::bits * k;
    }
  }
  return leaf;
}

}  // namespace gabarit
