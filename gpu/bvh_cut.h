// Where to cut a range of boxes in two: binned surface area heuristic along all three axes.
#pragma once

#include <array>
#include <span>

#include "gpu/bvh_build.h"

namespace gabarit {

// x, y, z and something that is of no interest, in one register.
using Lanes = float __attribute__((vector_size(16)));

struct LaneBox {
  static constexpr float far = std::numeric_limits<float>::infinity();
  Lanes lo{far, far, far, far}, hi{-far, -far, -far, -far};

  void add(const LaneBox& b) {
    lo = b.lo < lo ? b.lo : lo;
    hi = b.hi > hi ? b.hi : hi;
  }
  Box3f box() const { return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}}; }
};

LaneBox lanes_of(const BoxedPrimitive& b);

// Twice the centres of boxes: what the bins divide evenly.
struct CentreBox {
  LaneBox box;

  explicit CentreBox(std::span<const BoxedPrimitive> boxes = {});
};

struct Cut {
  float cost = std::numeric_limits<float>::infinity();  // infinite: there is none
  std::size_t axis = 0;
  int last_left_bin = 0;
  Box3f left, right;
};

class Bins {
 public:
  static constexpr int count = 16;
  static constexpr std::uint32_t any_number = 0xffffffffU;

  explicit Bins(const CentreBox& centres);
  void add(std::span<const BoxedPrimitive> boxes);
  void add(const Bins& other);
  // Of the cuts that leave both sides room in so many leaves together.
  Cut cheapest_cut(std::uint32_t leaves) const;
  // The same arithmetic as in filling the bins.
  bool is_left(const BoxedPrimitive& b, const Cut& cut) const {
    const int k = static_cast<int>(cut.axis);
    const float at = (b.box.min[k] + b.box.max[k] - from_[k]) * scale_[k];
    return at < static_cast<float>(cut.last_left_bin + 1);
  }

 private:
  using Numbers = std::int32_t __attribute__((vector_size(16)));
  struct Bin {
    LaneBox box;
    std::uint32_t count = 0;

    void add(const Bin& b) { box.add(b.box), count += b.count; }
  };
  Numbers numbers(const LaneBox& box) const;
  void keep_cheapest(std::size_t axis, std::uint32_t leaves, Cut& best) const;

  Lanes from_{}, scale_{};
  std::array<std::array<Bin, count>, 3> bins_;
};

inline std::uint32_t leaves_for(std::uint32_t primitives) {
  return (primitives + leaf_width - 1) / leaf_width;
}
float half_area(const Box3f& box);

}  // namespace gabarit
