#include "gpu/bvh_leaf.h"

#include "gpu/bvh_pack.h"

namespace gabarit {

BvhLeaf packed(std::span<const BoxedPrimitive> boxes, std::uint32_t first) {
  return pack(boxes.data(), static_cast<std::uint32_t>(boxes.size()), first);
}

}  // namespace gabarit
