#include <utility>

#include "gpu/bvh_pack.h"
#include "gpu/parallel_for.h"
#include "gpu/prefix_sums.h"
#include "gpu/wide_tree.h"

namespace gabarit {
namespace {

// A node to be made.
struct Wanted {
  BuildRange range;
  std::uint32_t binary;  // node
  std::uint32_t parent;
};

struct WantRoot {
  View<const BinaryNode> nodes;
  View<Wanted> wanted;

  GABARIT_HD void operator()(std::int64_t) const { wanted[0] = {nodes[0].range, 0, root_parent}; }
};

struct Part {
  BuildRange range;
  std::uint32_t binary = no_child;  // of ranges that are nodes of the binary tree
};

struct Parts {
  Part part[tree_width];
  int size = 0;

  GABARIT_HD bool is_leaf(int i) const { return part[i].range.count() <= leaf_width; }
};

// Up to eight parts of each node, and how many of them are leaves.
struct FindParts {
  View<const Wanted> wanted;
  View<const BinaryNode> nodes;
  View<BoxedPrimitive> boxes;
  View<Parts> parts;
  View<std::uint32_t> leaves, inner;  // numbers, by node

  GABARIT_HD void operator()(std::int64_t i) const {
    Parts found;
    if (wanted[i].range.count() <= bottom_size)
      add_leaves(wanted[i].range, found);
    else
      open(wanted[i], found);
    leaves[i] = 0;
    for (int k = 0; k < found.size; ++k) leaves[i] += found.is_leaf(k) ? 1 : 0;
    inner[i] = static_cast<std::uint32_t>(found.size) - leaves[i];
    parts[i] = found;
  }

 private:
  GABARIT_HD void add_leaves(const BuildRange& range, Parts& found) const {
    const BottomLeaves bottom(boxes.data, range);
    for (; found.size < bottom.size; ++found.size) found.part[found.size].range = bottom.leaf[found.size];
  }
  GABARIT_HD void open(const Wanted& node, Parts& found) const {
    found.part[found.size++] = {node.range, node.binary};
    while (found.size < tree_width) {
      int widest = -1;
      float most = 0;
      for (int k = 0; k < found.size; ++k) {
        const BuildRange& range = found.part[k].range;
        if (range.count() <= bottom_size) continue;
        const float weight = half_area_of(range.box) * static_cast<float>(range.count());
        if (widest < 0 || weight > most) widest = k, most = weight;
      }
      if (widest < 0) break;
      const std::uint32_t left = nodes[found.part[widest].binary].left;
      for (int k = found.size++; k > widest + 1; --k) found.part[k] = found.part[k - 1];
      found.part[widest] = {nodes[left].range, left};
      found.part[widest + 1] = {nodes[left + 1].range, left + 1};
    }
    for (int k = 0; k < found.size; ++k)
      if (found.is_leaf(k)) sort(found.part[k].range);
  }
  GABARIT_HD void sort(const BuildRange& range) const {
    for (std::uint32_t i = range.begin + 1; i < range.end; ++i) {
      for (std::uint32_t k = i; k > range.begin && boxes[k].primitive < boxes[k - 1].primitive; --k) {
        const BoxedPrimitive b = boxes[k];
        boxes[k] = boxes[k - 1];
        boxes[k - 1] = b;
      }
    }
  }
};

// One level: nodes and leaves, and what the next level has to be.
struct MakeNodes {
  View<const Wanted> wanted;
  View<const Parts> parts;
  View<const std::uint32_t> leaves_before, inner_before;
  View<const BoxedPrimitive> boxes;
  std::uint32_t first_node, next_node, first_leaf;  // numbers
  View<BvhNode> nodes;                              // of this level
  View<BvhLeaf> leaves;
  View<std::uint32_t> parent;
  View<std::uint32_t> home;
  View<Wanted> next;

  GABARIT_HD void operator()(std::int64_t i) const {
    const Parts& all = parts[i];
    const std::uint32_t number = first_node + static_cast<std::uint32_t>(i);
    std::uint32_t leaf = leaves_before[i], inner = inner_before[i];
    BvhNode node = empty_node();
    for (int k = 0; k < all.size; ++k) {
      const BuildRange& range = all.part[k].range;
      for (int axis = 0; axis < 3; ++axis) {
        node.lo[axis][k] = range.box.min[axis];
        node.hi[axis][k] = range.box.max[axis];
      }
      const std::uint32_t place = 8 * number + static_cast<std::uint32_t>(k);
      if (all.is_leaf(k)) {
        node.child[k] = leaf_flag | (first_leaf + leaf);
        leaves[leaf++] = pack(boxes.data + range.begin, range.count(), range.begin);
        for (std::uint32_t p = range.begin; p < range.end; ++p) home[p] = place;
      } else {
        node.child[k] = next_node + inner;
        next[inner++] = {range, all.part[k].binary, place};
      }
    }
    nodes[i] = node;
    parent[i] = wanted[i].parent;
  }
};

template <class T>
struct CopyTo {
  View<const T> from;
  View<T> to;
  std::int64_t first;

  GABARIT_HD void operator()(std::int64_t i) const { to[first + i] = from[i]; }
};

template <class T>
void append(const Device& device, Buffer<T>& all, const Buffer<T>& more) {
  auto both = Buffer<T>::of_size(device, all.size() + more.size());
  parallel_for(device, all.size(), CopyTo<T>{std::as_const(all).view(), both.view(), 0});
  parallel_for(device, more.size(), CopyTo<T>{more.view(), both.view(), all.size()});
  all = std::move(both);
}

class Levels {
 public:
  Levels(const Device& device, BinaryTree& binary) : device_(device), binary_(binary) {
    const std::int64_t n = binary.boxes.size();
    tree_.home = Buffer<std::uint32_t>::of_size(device, n);
    wanted_ = Buffer<Wanted>::of_size(device, 1);
    parallel_for(device, 1, WantRoot{std::as_const(binary.nodes).view(), wanted_.view()});
  }

  bool run() {
    for (int depth = 0; wanted_.size() > 0; ++depth) {
      if (depth == greatest_sah_depth) return false;
      add_level();
    }
    return true;
  }
  WideTree take() && { return std::move(tree_); }

 private:
  void add_level() {
    const std::int64_t count = wanted_.size();
    auto parts = Buffer<Parts>::of_size(device_, count);
    auto leaves = Buffer<std::uint32_t>::of_size(device_, count),
         inner = Buffer<std::uint32_t>::of_size(device_, count);
    const View<const Wanted> wanted = std::as_const(wanted_).view();
    parallel_for(device_, count,
                 FindParts{wanted, std::as_const(binary_.nodes).view(), binary_.boxes.view(), parts.view(),
                           leaves.view(), inner.view()},
                 16);
    const PrefixSums leaf_numbers = prefix_sums(device_, leaves), inner_numbers = prefix_sums(device_, inner);
    const auto first_node = static_cast<std::uint32_t>(tree_.nodes.size());
    auto nodes = Buffer<BvhNode>::of_size(device_, count);
    auto packed_leaves = Buffer<BvhLeaf>::of_size(device_, leaf_numbers.total);
    auto parent = Buffer<std::uint32_t>::of_size(device_, count);
    auto next = Buffer<Wanted>::of_size(device_, inner_numbers.total);
    parallel_for(device_, count,
                 MakeNodes{wanted, std::as_const(parts).view(), leaf_numbers.before.view(),
                           inner_numbers.before.view(), std::as_const(binary_.boxes).view(), first_node,
                           first_node + static_cast<std::uint32_t>(count),
                           static_cast<std::uint32_t>(tree_.leaves.size()), nodes.view(),
                           packed_leaves.view(), parent.view(), tree_.home.view(), next.view()},
                 16);
    append(device_, tree_.nodes, nodes);
    append(device_, tree_.leaves, packed_leaves);
    append(device_, tree_.parent, parent);
    wanted_ = std::move(next);
  }

  Device device_;
  BinaryTree& binary_;
  WideTree tree_;
  Buffer<Wanted> wanted_;
};

}  // namespace

std::optional<WideTree> wide_tree(const Device& device, BinaryTree& binary) {
  Levels levels(device, binary);
  if (!levels.run()) return std::nullopt;
  return std::move(levels).take();
}

}  // namespace gabarit
