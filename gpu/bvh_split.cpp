#include <algorithm>
#include <numeric>
#include <utility>

#include "gpu/bvh_cut.h"
#include "gpu/bvh_limits.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

struct Range {
  std::uint32_t begin = 0, end = 0;
  Box3f box;

  std::uint32_t count() const { return end - begin; }
};

int longest_axis(const Box3f& box) {
  const Vec3f e = box.extent();
  return e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
}

// Work on ranges larger than this is shared between threads, in chunks of this many.
constexpr std::uint32_t chunk = 1 << 15;

class Splitter {
 public:
  Splitter(const Device& device, std::vector<BoxedPrimitive>& boxes) : device_(device), boxes_(&boxes) {}

  Range whole() const { return bounded(0, static_cast<std::uint32_t>(boxes_->size())); }

  std::span<const BoxedPrimitive> boxes(const Range& range) const {
    return std::span(*boxes_).subspan(range.begin, range.count());
  }

  // In leaves, so that the tree does not depend on how ranges were partitioned.
  void order_by_primitive(const Range& range) {
    const auto begin = boxes_->begin() + range.begin;
    std::sort(begin, begin + range.count(),
              [](const BoxedPrimitive& a, const BoxedPrimitive& b) { return a.primitive < b.primitive; });
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
  std::pair<Range, Range> split(const Range& range, std::uint32_t leaves = Bins::any_number) {
    const Bins bins = filled(range);
    const Cut cut = bins.cheapest_cut(leaves);
    if (cut.cost == std::numeric_limits<float>::infinity()) return halve(range, leaves);
    const std::uint32_t middle =
        range.begin + partition(range, [&](const BoxedPrimitive& b) { return bins.is_left(b, cut); });
    return {Range{range.begin, middle, cut.left}, Range{middle, range.end, cut.right}};
  }

  Bins filled(const Range& range) const {
    std::vector<CentreBox> centres(chunks(range));
    for_chunks(range, [&](std::size_t i, const Range& part) { centres[i] = CentreBox(boxes(part)); });
    for (const CentreBox& c : centres) centres.front().box.add(c.box);
    std::vector<Bins> bins(centres.size(), Bins(centres.front()));
    for_chunks(range, [&](std::size_t i, const Range& part) { bins[i].add(boxes(part)); });
    for (std::size_t i = 1; i < bins.size(); ++i) bins.front().add(bins[i]);
    return bins.front();
  }

  // Puts those that are left first, in their order; gives their number.
  template <class IsLeft>
  std::uint32_t partition(const Range& range, IsLeft&& is_left) {
    const auto begin = boxes_->begin() + range.begin;
    if (range.count() <= chunk)
      return static_cast<std::uint32_t>(std::partition(begin, begin + range.count(), is_left) - begin);
    std::vector<std::uint32_t> lefts(chunks(range));
    for_chunks(range, [&](std::size_t i, const Range& part) {
      const auto all = boxes(part);
      lefts[i] = static_cast<std::uint32_t>(std::count_if(all.begin(), all.end(), is_left));
    });
    const std::uint32_t left = std::reduce(lefts.begin(), lefts.end());
    std::vector<BoxedPrimitive> sorted(range.count());
    std::exclusive_scan(lefts.begin(), lefts.end(), lefts.begin(), 0U);
    for_chunks(range, [&](std::size_t i, const Range& part) {
      std::uint32_t to_left = lefts[i], to_right = left + part.begin - range.begin - lefts[i];
      for (const BoxedPrimitive& b : boxes(part)) sorted[is_left(b) ? to_left++ : to_right++] = b;
    });
    for_chunks(range, [&](std::size_t, const Range& part) {
      std::copy_n(sorted.begin() + (part.begin - range.begin), part.count(), boxes_->begin() + part.begin);
    });
    return left;
  }

  static std::size_t chunks(const Range& range) { return range.count() / chunk + 1; }
  template <class Work>
  void for_chunks(const Range& range, Work&& work) const {
    parallel_for_cpu(
        device_, static_cast<std::int64_t>(chunks(range)),
        [&](std::int64_t i) {
          const std::uint32_t begin = range.begin + static_cast<std::uint32_t>(i) * chunk;
          work(static_cast<std::size_t>(i), Range{begin, std::min(begin + chunk, range.end), {}});
        },
        1);
  }

  std::pair<Range, Range> halve(const Range& range, std::uint32_t leaves = Bins::any_number) {
    const int axis = longest_axis(range.box);
    const std::uint32_t share =
        leaves == Bins::any_number ? range.count() / 2 : range.count() * (leaves / 2) / leaves;
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

  Device device_;
  std::vector<BoxedPrimitive>* boxes_;
};

// A range whose node is still to be made, and the child that will refer to it.
struct Pending {
  Range range;
  std::uint32_t node;
  int slot;
  int depth;
};

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
      splitter.order_by_primitive(part);
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
  Splitter splitter(device, boxes);
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
