// What one thread makes of a range that fits into the leaves of a single node: the same leaves as
// bvh_split.cpp makes.
#pragma once

#include "gpu/bvh_bins.h"
#include "gpu/bvh_limits.h"

namespace gabarit {

// A part of a range, and its box.
struct BuildRange {
  std::uint32_t begin = 0, end = 0;
  Box3f box;

  GABARIT_HD std::uint32_t count() const { return end - begin; }
};

// Sorts the range's boxes by leaf, and within a leaf by primitive.
class BottomLeaves {
 public:
  BuildRange leaf[tree_width];
  int size = 0;

  GABARIT_HD BottomLeaves(BoxedPrimitive* boxes, const BuildRange& range) : boxes_(boxes) {
    struct Task {
      BuildRange range;
      std::uint32_t leaves;
    };
    Task stack[tree_width];
    int top = 0;
    const std::uint32_t usual = (range.count() + usual_leaf_size - 1) / usual_leaf_size;
    stack[top++] = {range, usual < tree_width ? usual : tree_width};
    while (top > 0) {
      const Task task = stack[--top];
      if (task.leaves == 1) {
        sort(task.range,
             [](const BoxedPrimitive& a, const BoxedPrimitive& b) { return a.primitive < b.primitive; });
        leaf[size++] = task.range;
        continue;
      }
      BuildRange left, right;
      split(task.range, task.leaves, left, right);
      const std::uint32_t share = (task.leaves * left.count() + task.range.count() / 2) / task.range.count();
      const std::uint32_t least = fewest_leaves(left.count());
      const std::uint32_t most = task.leaves - fewest_leaves(right.count());
      const std::uint32_t first = share < least ? least : share > most ? most : share;
      stack[top++] = {right, task.leaves - first};
      stack[top++] = {left, first};
    }
  }

 private:
  GABARIT_HD Box3f bounded(std::uint32_t begin, std::uint32_t end) const {
    Box3f box;
    for (std::uint32_t i = begin; i < end; ++i) box.add(boxes_[i].box);
    return box;
  }

  GABARIT_HD void split(const BuildRange& range, std::uint32_t leaves, BuildRange& left, BuildRange& right) {
    Box3f centres;
    for (std::uint32_t i = range.begin; i < range.end; ++i)
      centres.add(boxes_[i].box.min + boxes_[i].box.max);
    const BinScale scale(centres);
    BinCut cut;
    for (int axis = 0; axis < 3; ++axis) {
      Bin bins[BinScale::count];
      for (std::uint32_t i = range.begin; i < range.end; ++i)
        bins[scale.bin(axis, boxes_[i].box)].add({boxes_[i].box, 1});
      keep_cheapest(
          axis, leaves, [&](int i) -> const Bin& { return bins[i]; }, cut);
    }
    if (cut.cost == std::numeric_limits<float>::infinity()) return halve(range, leaves, left, right);
    std::uint32_t middle = range.begin;
    for (std::uint32_t i = range.begin; i < range.end; ++i)
      if (cut.is_left(scale, boxes_[i].box)) swap(i, middle++);
    left = {range.begin, middle, cut.left};
    right = {middle, range.end, cut.right};
  }

  GABARIT_HD void halve(const BuildRange& range, std::uint32_t leaves, BuildRange& left, BuildRange& right) {
    const Vec3f e = range.box.extent();
    const int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
    sort(range, [axis](const BoxedPrimitive& a, const BoxedPrimitive& b) {
      const float x = a.box.min[axis] + a.box.max[axis], y = b.box.min[axis] + b.box.max[axis];
      return x < y || (x == y && a.primitive < b.primitive);
    });
    const std::uint32_t middle = range.begin + range.count() * (leaves / 2) / leaves;
    left = {range.begin, middle, bounded(range.begin, middle)};
    right = {middle, range.end, bounded(middle, range.end)};
  }

  template <class Before>
  GABARIT_HD void sort(const BuildRange& range, Before&& before) {
    for (std::uint32_t i = range.begin + 1; i < range.end; ++i)
      for (std::uint32_t k = i; k > range.begin && before(boxes_[k], boxes_[k - 1]); --k) swap(k, k - 1);
  }
  GABARIT_HD void swap(std::uint32_t i, std::uint32_t k) {
    const BoxedPrimitive b = boxes_[i];
    boxes_[i] = boxes_[k];
    boxes_[k] = b;
  }

  BoxedPrimitive* boxes_;
};

}  // namespace gabarit
