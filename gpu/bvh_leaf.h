// Up to eight primitives and their boxes, ten bits a coordinate: most primitives are discarded before their
// corners are looked at.
#pragma once

#include <cstdint>

#include "gpu/qualifiers.h"

namespace gabarit {

constexpr int leaf_width = 8;

struct alignas(32) BvhLeaf {
  static constexpr int bits = 10;
  static constexpr std::uint32_t most = (1U << bits) - 1;

  std::uint32_t lo[leaf_width];  // in steps, rounded outwards: x in the lowest bits, then y and z
  std::uint32_t hi[leaf_width];
  float from[3];  // relative to the origin of the tree
  float step[3];
  std::uint32_t first;  // primitive
  std::uint32_t count;  // of primitives; the boxes beyond mean nothing

  // By way of a signed number, for which there is a vector instruction.
  GABARIT_HD float place(int axis, std::uint32_t at) const {
    return from[axis] + step[axis] * static_cast<float>(static_cast<std::int32_t>(at));
  }
};

// Boxes side by side, relative to the origin of the tree.
struct EightBoxes {
  float lo[3][leaf_width];
  float hi[3][leaf_width];
};

GABARIT_HD inline EightBoxes boxes_of(const BvhLeaf& leaf) {
  EightBoxes boxes;
  GABARIT_UNROLL
  for (int i = 0; i < leaf_width; ++i) {
    for (int k = 0; k < 3; ++k) {
      boxes.lo[k][i] = leaf.place(k, leaf.lo[i] >> BvhLeaf::bits * k & BvhLeaf::most);
      boxes.hi[k][i] = leaf.place(k, leaf.hi[i] >> BvhLeaf::bits * k & BvhLeaf::most);
    }
  }
  return boxes;
}

}  // namespace gabarit
