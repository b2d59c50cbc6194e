// The cuts of bvh_cut.h as kernels make them: the same numbers, the same cuts. Boxes that many threads
// enlarge are kept as ordered numbers of which the least is wanted: low ends, and high ends negated.
#pragma once

#include "gpu/atomic.h"
#include "gpu/bvh_build.h"

namespace gabarit {

// May be enlarged by several threads at once; the result does not depend on their order.
struct SharedBox {
  std::uint32_t low[3], high[3];

  GABARIT_HD void clear() {
    for (int k = 0; k < 3; ++k) low[k] = high[k] = ordered(std::numeric_limits<float>::infinity());
  }
  GABARIT_HD void add(const Box3f& b) {
    for (int k = 0; k < 3; ++k) {
      lower_shared(low[k], ordered(b.min[k]));
      lower_shared(high[k], ordered(-b.max[k]));
    }
  }
  GABARIT_HD Box3f box() const {
    return {{from_ordered(low[0]), from_ordered(low[1]), from_ordered(low[2])},
            {-from_ordered(high[0]), -from_ordered(high[1]), -from_ordered(high[2])}};
  }
};

GABARIT_HD inline float half_area_of(const Box3f& box) {
  const Vec3f e = box.extent();
  return e.x * e.y + e.y * e.z + e.z * e.x;
}
GABARIT_HD inline std::uint32_t fewest_leaves(std::uint32_t primitives) {
  return (primitives + leaf_width - 1) / leaf_width;
}

struct BinScale {
  static constexpr int count = 16;
  float from[3], scale[3];

  // `centres`: of twice the centres of the boxes.
  GABARIT_HD explicit BinScale(const Box3f& centres) {
    for (int k = 0; k < 3; ++k) {
      const float extent = centres.max[k] - centres.min[k];
      from[k] = centres.min[k];
      scale[k] = extent > 0 ? static_cast<float>(count) * 0.9999F / extent : 0.0F;
    }
  }
  GABARIT_HD float at(int axis, const Box3f& box) const {
    return (box.min[axis] + box.max[axis] - from[axis]) * scale[axis];
  }
  GABARIT_HD int bin(int axis, const Box3f& box) const {
    const float x = at(axis, box);
    const float above = x > 0 ? x : 0.0F;
    return static_cast<int>(above < count - 1 ? above : count - 1.0F);
  }
};

struct BinCut {
  float cost = std::numeric_limits<float>::infinity();  // infinite: there is none
  int axis = 0, last_left_bin = 0;
  std::uint32_t left_count = 0;
  Box3f left, right;

  GABARIT_HD bool is_left(const BinScale& scale, const Box3f& box) const {
    return scale.at(axis, box) < static_cast<float>(last_left_bin + 1);
  }
};

struct Bin {
  Box3f box;
  std::uint32_t count = 0;

  GABARIT_HD void add(const Bin& b) { box.add(b.box), count += b.count; }
};

// Keeps the cheapest cut along one axis, of bin(i), if it is cheaper than `best`.
template <class BinOf>
GABARIT_HD void keep_cheapest(int axis, std::uint32_t leaves, BinOf&& bin, BinCut& best) {
  Bin right[BinScale::count], sum;
  for (int i = BinScale::count; i-- > 0;) sum.add(bin(i)), right[i] = sum;
  sum = Bin{};
  for (int i = 0; i + 1 < BinScale::count; ++i) {
    const Bin own = bin(i);
    sum.add(own);
    const Bin& other = right[i + 1];
    if (own.count == 0 || other.count == 0) continue;
    if (fewest_leaves(sum.count) + fewest_leaves(other.count) > leaves) continue;
    const float cost = half_area_of(sum.box) * static_cast<float>(sum.count) +
                       half_area_of(other.box) * static_cast<float>(other.count);
    if (cost < best.cost) best = {cost, axis, i, sum.count, sum.box, other.box};
  }
}

}  // namespace gabarit
