#include <algorithm>
#include <utility>

#include "gpu/bvh_build.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

// What one node can hold in leaves that are not quite full; parts of this size are not split between nodes.
constexpr std::uint32_t bottom_size = 48;
constexpr std::uint32_t usual_leaf_size = 6;
constexpr int bin_count = 16;
// From this depth on ranges are halved by count: no input makes the tree deeper than the queries' stacks.
constexpr int greatest_sah_depth = 14;

struct Range {
  std::uint32_t begin = 0, end = 0;
  Box3f box;

  std::uint32_t count() const { return end - begin; }
};

float half_area(const Box3f& box) {
  const Vec3f e = box.extent();
  return e.x * e.y + e.y * e.z + e.z * e.x;
}

int longest_axis(const Box3f& box) {
  const Vec3f e = box.extent();
  return e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
}

struct Bin {
  Box3f box;
  std::uint32_t count = 0;

  void add(const Bin& b) { box.add(b.box), count += b.count; }
};

// Twice the centre of a box, and the bins it falls into.
struct Binning {
  Vec3f from, scale;

  explicit Binning(const Box3f& centres) : from(centres.min) {
    const Vec3f e = centres.extent();
    for (int k = 0; k < 3; ++k) scale[k] = e[k] > 0 ? static_cast<float>(bin_count) * 0.9999F / e[k] : 0.0F;
  }
  int bin(const Box3f& box, int axis) const {
    return std::clamp(static_cast<int>((box.min[axis] + box.max[axis] - from[axis]) * scale[axis]), 0,
                      bin_count - 1);
  }
};

struct Cut {
  float cost = std::numeric_limits<float>::infinity();
  int axis = 0, last_left_bin = 0;
  Box3f left, right;
};

std::uint32_t leaves_for(std::uint32_t count) { return (count + leaf_width - 1) / leaf_width; }

// Of the cuts across an axis that leave both sides room in `leaves` leaves together.
void keep_cheapest(const std::array<Bin, bin_count>& bins, int axis, std::uint32_t leaves, Cut& best) {
  std::array<Bin, bin_count> right;
  Bin sum;
  for (std::size_t i = bin_count; i-- > 0;) sum.add(bins[i]), right[i] = sum;
  sum = {};
  for (std::size_t i = 0; i + 1 < bin_count; ++i) {
    sum.add(bins[i]);
    const Bin& other = right[i + 1];
    if (sum.count == 0 || other.count == 0) continue;
    if (leaves_for(sum.count) + leaves_for(other.count) > leaves) continue;
    const float cost = half_area(sum.box) * static_cast<float>(sum.count) +
                       half_area(other.box) * static_cast<float>(other.count);
    if (cost < best.cost) best = {cost, axis, static_cast<int>(i), sum.box, other.box};
  }
}

class Splitter {
 public:
  explicit Splitter(std::vector<BoxedPrimitive>& boxes) : boxes_(&boxes) {}

  Range whole() const { return bounded(0, static_cast<std::uint32_t>(boxes_->size())); }

  std::span<const BoxedPrimitive> boxes(const Range& range) const {
    return std::span(*boxes_).subspan(range.begin, range.count());
  }

  // Up to eight parts of a range, in order: all of them leaves when they can be.
  std::vector<Range> parts(const Range& range, int depth) {
    if (range.count() <= bottom_size) return leaves(range);
    std::vector<Range> parts{range};
    while (parts.size() < tree_width) {
      auto widest = parts.end();
      for (auto it = parts.begin(); it != parts.end(); ++it) {
        if (it->count() > bottom_size &&
            (widest == parts.end() || weight(*it, depth) > weight(*widest, depth)))
          widest = it;
      }
      if (widest == parts.end()) break;
      const auto [left, right] = depth < greatest_sah_depth ? split(*widest) : halve(*widest);
      *widest = left;
      parts.insert(widest + 1, right);
    }
    return parts;
  }

 private:
  static constexpr std::uint32_t any_number = 0xffffffffU;

  std::vector<Range> leaves(const Range& range) {
    std::vector<Range> parts;
    const std::uint32_t usual = (range.count() + usual_leaf_size - 1) / usual_leaf_size;
    add_leaves(range, std::min<std::uint32_t>(usual, tree_width), parts);
    return parts;
  }

  void add_leaves(const Range& range, std::uint32_t count, std::vector<Range>& parts) {
    if (count == 1) return parts.push_back(range);
    const auto [left, right] = split(range, count);
    const std::uint32_t share = (count * left.count() + range.count() / 2) / range.count();
    const std::uint32_t first =
        std::clamp(share, leaves_for(left.count()), count - leaves_for(right.count()));
    add_leaves(left, first, parts);
    add_leaves(right, count - first, parts);
  }

  static float weight(const Range& r, int depth) {
    return depth < greatest_sah_depth ? half_area(r.box) * static_cast<float>(r.count())
                                      : static_cast<float>(r.count());
  }

  Range bounded(std::uint32_t begin, std::uint32_t end) const {
    Range range{begin, end, {}};
    for (std::uint32_t i = begin; i < end; ++i) range.box.add((*boxes_)[i].box);
    return range;
  }

  // `leaves`: how many both sides may take up together.
  std::pair<Range, Range> split(const Range& range, std::uint32_t leaves = any_number) {
    Box3f centres;
    for (std::uint32_t i = range.begin; i < range.end; ++i)
      centres.add((*boxes_)[i].box.min + (*boxes_)[i].box.max);
    const Binning binning(centres);
    std::array<std::array<Bin, bin_count>, 3> bins;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const Box3f& box = (*boxes_)[i].box;
      for (int k = 0; k < 3; ++k) {
        Bin& bin = bins[static_cast<std::size_t>(k)][static_cast<std::size_t>(binning.bin(box, k))];
        bin.box.add(box);
        ++bin.count;
      }
    }
    Cut cut;
    for (int k = 0; k < 3; ++k) keep_cheapest(bins[static_cast<std::size_t>(k)], k, leaves, cut);
    if (cut.cost == std::numeric_limits<float>::infinity()) return halve(range, leaves);
    const auto begin = boxes_->begin();
    const auto mid = std::partition(begin + range.begin, begin + range.end, [&](const BoxedPrimitive& b) {
      return binning.bin(b.box, cut.axis) <= cut.last_left_bin;
    });
    const auto middle = static_cast<std::uint32_t>(mid - begin);
    return {Range{range.begin, middle, cut.left}, Range{middle, range.end, cut.right}};
  }

  std::pair<Range, Range> halve(const Range& range, std::uint32_t leaves = any_number) {
    const int axis = longest_axis(range.box);
    const std::uint32_t share =
        leaves == any_number ? range.count() / 2 : range.count() * (leaves / 2) / leaves;
    const std::uint32_t middle = range.begin + share;
    const auto begin = boxes_->begin();
    std::nth_element(begin + range.begin, begin + middle, begin + range.end,
                     [axis](const BoxedPrimitive& a, const BoxedPrimitive& b) {
                       const float x = a.box.min[axis] + a.box.max[axis];
                       const float y = b.box.min[axis] + b.box.max[axis];
                       return x < y || (x == y && a.primitive < b.primitive);
                     });
    return {bounded(range.begin, middle), bounded(middle, range.end)};
  }

  std::vector<BoxedPrimitive>* boxes_;
};

// A range whose node is still to be made, and the child that will refer to it.
struct Pending {
  Range range;
  std::uint32_t node;
  int slot;
  int depth;
};

BvhNode empty_node() {
  BvhNode node{};
  for (int i = 0; i < tree_width; ++i) {
    for (int k = 0; k < 3; ++k) {
      node.lo[k][i] = std::numeric_limits<float>::infinity();
      node.hi[k][i] = -std::numeric_limits<float>::infinity();
    }
    node.child[i] = no_child;
  }
  return node;
}

// Makes one node; the parts that are no leaves go to `pending`.
void add_node(Splitter& splitter, const Range& range, int depth, SplitTree& tree,
              std::vector<Pending>& pending) {
  const auto number = static_cast<std::uint32_t>(tree.nodes.size());
  BvhNode node = empty_node();
  std::array<PrimitiveRange, tree_width> ranges;
  int slot = 0;
  for (const Range& part : splitter.parts(range, depth)) {
    for (int k = 0; k < 3; ++k) node.lo[k][slot] = part.box.min[k], node.hi[k][slot] = part.box.max[k];
    ranges[static_cast<std::size_t>(slot)] = {part.begin, part.end};
    if (part.count() <= leaf_width) {
      node.child[slot] = leaf_flag | static_cast<std::uint32_t>(tree.leaves.size());
      tree.leaves.push_back(packed(splitter.boxes(part), part.begin));
    } else {
      pending.push_back({part, number, slot, depth + 1});
    }
    ++slot;
  }
  tree.nodes.push_back(node);
  tree.ranges.push_back(ranges);
}

// All nodes below a range; the first of them is its root.
SplitTree subtree(Splitter splitter, const Range& range, int depth) {
  SplitTree tree;
  std::vector<Pending> pending;
  add_node(splitter, range, depth, tree, pending);
  while (!pending.empty()) {
    const Pending next = pending.back();
    pending.pop_back();
    tree.nodes[next.node].child[next.slot] = static_cast<std::uint32_t>(tree.nodes.size());
    add_node(splitter, next.range, next.depth, tree, pending);
  }
  return tree;
}

// Nodes of large ranges, breadth first; what is small enough to be one thread's work is left over.
std::vector<Pending> top_of_tree(Splitter& splitter, SplitTree& tree, std::uint32_t small) {
  std::vector<Pending> queue;
  std::vector<Pending> rest;
  add_node(splitter, splitter.whole(), 0, tree, queue);
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Pending next = queue[i];
    if (next.range.count() <= small) {
      rest.push_back(next);
      continue;
    }
    tree.nodes[next.node].child[next.slot] = static_cast<std::uint32_t>(tree.nodes.size());
    add_node(splitter, next.range, next.depth, tree, queue);
  }
  return rest;
}

void append(SplitTree& tree, const Pending& place, SplitTree part) {
  const auto nodes = static_cast<std::uint32_t>(tree.nodes.size());
  const auto leaves = static_cast<std::uint32_t>(tree.leaves.size());
  tree.nodes[place.node].child[place.slot] = nodes;
  for (BvhNode& node : part.nodes) {
    for (std::uint32_t& child : node.child) {
      if (child != no_child) child += (child & leaf_flag) == 0 ? nodes : leaves;
    }
  }
  tree.leaves.insert(tree.leaves.end(), part.leaves.begin(), part.leaves.end());
  tree.nodes.insert(tree.nodes.end(), part.nodes.begin(), part.nodes.end());
  tree.ranges.insert(tree.ranges.end(), part.ranges.begin(), part.ranges.end());
}

}  // namespace

SplitTree split_into_nodes(const Device& device, std::vector<BoxedPrimitive>& boxes) {
  SplitTree tree;
  if (boxes.empty()) return tree;
  Splitter splitter(boxes);
  const auto small = std::max<std::uint32_t>(4096, static_cast<std::uint32_t>(boxes.size() / 64));
  const std::vector<Pending> rest = top_of_tree(splitter, tree, small);
  std::vector<SplitTree> parts(rest.size());
  parallel_for_cpu(
      device, static_cast<std::int64_t>(rest.size()),
      [&](std::int64_t i) {
        const auto k = static_cast<std::size_t>(i);
        parts[k] = subtree(splitter, rest[k].range, rest[k].depth);
      },
      1);
  for (std::size_t i = 0; i < rest.size(); ++i) append(tree, rest[i], std::move(parts[i]));
  return tree;
}

}  // namespace gabarit
