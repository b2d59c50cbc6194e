#include <utility>

#include "gpu/binary_tree.h"
#include "gpu/parallel_for.h"
#include "gpu/prefix_sums.h"

namespace gabarit {
namespace {

constexpr std::uint32_t nobody = 0xffffffffU;

// What is known of a range that is about to be cut.
struct Cutting {
  SharedBox centres;  // twice the centres
  SharedBox bin[3][BinScale::count];
  std::uint32_t in_bin[3][BinScale::count];
  BinCut cut;
};

struct Clear {
  View<Cutting> cuttings;

  GABARIT_HD void operator()(std::int64_t i) const {
    Cutting& c = cuttings[i];
    c.centres.clear();
    for (int k = 0; k < 3; ++k)
      for (int b = 0; b < BinScale::count; ++b) c.bin[k][b].clear(), c.in_bin[k][b] = 0;
  }
};

struct FindCentres {
  View<const BoxedPrimitive> boxes;
  View<const std::uint32_t> owner;  // by place: the cutting that it belongs to
  View<Cutting> cuttings;

  GABARIT_HD void operator()(std::int64_t i) const {
    if (owner[i] == nobody) return;
    const Vec3f twice = boxes[i].box.min + boxes[i].box.max;
    cuttings[owner[i]].centres.add({twice, twice});
  }
};

struct FillBins {
  View<const BoxedPrimitive> boxes;
  View<const std::uint32_t> owner;
  View<Cutting> cuttings;

  GABARIT_HD void operator()(std::int64_t i) const {
    if (owner[i] == nobody) return;
    Cutting& c = cuttings[owner[i]];
    const BinScale scale(c.centres.box());
    for (int k = 0; k < 3; ++k) {
      const int b = scale.bin(k, boxes[i].box);
      c.bin[k][b].add(boxes[i].box);
      fetch_add(c.in_bin[k][b], 1);
    }
  }
};

struct ChooseCuts {
  View<Cutting> cuttings;
  View<const std::uint32_t> active;  // nodes, by cutting
  View<BinaryNode> nodes;
  std::uint32_t children;       // number of the first new node
  View<std::uint32_t> goes_on;  // by new node: 1 when it is cut in the next round
  View<std::uint8_t> odd;

  GABARIT_HD void operator()(std::int64_t i) const {
    Cutting& c = cuttings[i];
    BinCut cut;
    for (int k = 0; k < 3; ++k)
      keep_cheapest(
          k, nobody,
          [&](int b) {
            return Bin{c.bin[k][b].box(), c.in_bin[k][b]};
          },
          cut);
    if (cut.cost == std::numeric_limits<float>::infinity()) store_shared(odd[0], 1);
    c.cut = cut;
    BinaryNode& node = nodes[active[i]];
    const std::uint32_t middle = node.range.begin + cut.left_count;
    node.left = children + 2 * static_cast<std::uint32_t>(i);
    nodes[node.left].range = {node.range.begin, middle, cut.left};
    nodes[node.left + 1].range = {middle, node.range.end, cut.right};
    for (int side = 0; side < 2; ++side) {
      nodes[node.left + static_cast<std::uint32_t>(side)].left = no_child;
      goes_on[2 * i + side] =
          nodes[node.left + static_cast<std::uint32_t>(side)].range.count() > bottom_size ? 1 : 0;
    }
  }
};

struct TellSides {
  View<const BoxedPrimitive> boxes;
  View<const std::uint32_t> owner;
  View<const Cutting> cuttings;
  View<std::uint32_t> is_left;

  GABARIT_HD void operator()(std::int64_t i) const {
    is_left[i] = 0;
    if (owner[i] == nobody) return;
    const Cutting& c = cuttings[owner[i]];
    is_left[i] = c.cut.is_left(BinScale(c.centres.box()), boxes[i].box) ? 1 : 0;
  }
};

// Those that are left come first, in their order; so do those that are right.
struct Scatter {
  View<const BoxedPrimitive> boxes;
  View<const std::uint32_t> owner, is_left, lefts_before;
  View<const std::uint32_t> active;
  View<const BinaryNode> nodes;
  View<const std::uint32_t> goes_on, next_cutting;
  View<BoxedPrimitive> sorted;
  View<std::uint32_t> next_owner;

  GABARIT_HD void operator()(std::int64_t i) const {
    if (owner[i] == nobody) {
      sorted[i] = boxes[i];
      next_owner[i] = nobody;
      return;
    }
    const BinaryNode& node = nodes[active[owner[i]]];
    const std::uint32_t begin = node.range.begin;
    const std::uint32_t lefts = lefts_before[i] - lefts_before[begin];
    const std::uint32_t rights = static_cast<std::uint32_t>(i) - begin - lefts;
    const std::uint32_t side = is_left[i] != 0 ? 0 : 1;
    const std::uint32_t to = side == 0 ? begin + lefts : nodes[node.left + 1].range.begin + rights;
    const std::uint32_t child = 2 * owner[i] + side;
    sorted[to] = boxes[i];
    next_owner[to] = goes_on[child] != 0 ? next_cutting[child] : nobody;
  }
};

struct ListActive {
  View<const std::uint32_t> goes_on, next_cutting;
  std::uint32_t children;
  View<std::uint32_t> active;

  GABARIT_HD void operator()(std::int64_t i) const {
    if (goes_on[i] != 0) active[next_cutting[i]] = children + static_cast<std::uint32_t>(i);
  }
};

template <class T>
struct Copy {
  View<const T> from;
  View<T> to;

  GABARIT_HD void operator()(std::int64_t i) const { to[i] = from[i]; }
};

class Rounds {
 public:
  Rounds(const Device& device, Buffer<BoxedPrimitive> boxes, const Box3f& box)
      : device_(device), boxes_(std::move(boxes)), sorted_(Buffer<BoxedPrimitive>::of_size(device, size())) {
    const auto count = static_cast<std::uint32_t>(size());
    nodes_ = Buffer<BinaryNode>(device, std::vector<BinaryNode>{{{0, count, box}, no_child}});
    const bool small = count <= bottom_size;
    owner_ = Buffer<std::uint32_t>(device, std::vector<std::uint32_t>(count, small ? nobody : 0));
    next_owner_ = Buffer<std::uint32_t>::of_size(device, size());
    if (!small) active_ = Buffer<std::uint32_t>(device, std::vector<std::uint32_t>{0});
  }

  // Deeper than this a tree of nodes of eight, each of seven cuts in a row, is only halved by count.
  bool run() {
    for (int round = 0; active_.size() > 0; ++round) {
      if (round == greatest_sah_depth * (tree_width - 1) || !cut_all()) return false;
    }
    return true;
  }
  BinaryTree take() && { return {std::move(nodes_), std::move(boxes_)}; }

 private:
  std::int64_t size() const { return boxes_.size(); }

  void grow(std::int64_t more) {
    auto nodes = Buffer<BinaryNode>::of_size(device_, nodes_.size() + more);
    parallel_for(device_, nodes_.size(), Copy<BinaryNode>{std::as_const(nodes_).view(), nodes.view()});
    nodes_ = std::move(nodes);
  }

  bool cut_all() {
    const std::int64_t n = size(), count = active_.size();
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    grow(2 * count);
    auto cuttings = Buffer<Cutting>::of_size(device_, count);
    auto goes_on = Buffer<std::uint32_t>::of_size(device_, 2 * count);
    Buffer<std::uint8_t> odd(device_, std::vector<std::uint8_t>{0});
    const View<const BoxedPrimitive> boxes = std::as_const(boxes_).view();
    const View<const std::uint32_t> owner = std::as_const(owner_).view(),
                                    active = std::as_const(active_).view();
    parallel_for(device_, count, Clear{cuttings.view()}, 16);
    parallel_for(device_, n, FindCentres{boxes, owner, cuttings.view()});
    parallel_for(device_, n, FillBins{boxes, owner, cuttings.view()});
    parallel_for(device_, count,
                 ChooseCuts{cuttings.view(), active, nodes_.view(), children, goes_on.view(), odd.view()},
                 16);
    if (odd.read().front() != 0) return false;
    auto is_left = Buffer<std::uint32_t>::of_size(device_, n);
    parallel_for(device_, n, TellSides{boxes, owner, std::as_const(cuttings).view(), is_left.view()});
    move(is_left, goes_on, children);
    return true;
  }

  void move(const Buffer<std::uint32_t>& is_left, const Buffer<std::uint32_t>& goes_on,
            std::uint32_t children) {
    const PrefixSums lefts = prefix_sums(device_, is_left);
    const PrefixSums cutting = prefix_sums(device_, goes_on);
    parallel_for(device_, size(),
                 Scatter{std::as_const(boxes_).view(), std::as_const(owner_).view(), is_left.view(),
                         lefts.before.view(), std::as_const(active_).view(), std::as_const(nodes_).view(),
                         goes_on.view(), cutting.before.view(), sorted_.view(), next_owner_.view()});
    auto active = Buffer<std::uint32_t>::of_size(device_, cutting.total);
    parallel_for(device_, goes_on.size(),
                 ListActive{goes_on.view(), cutting.before.view(), children, active.view()});
    active_ = std::move(active);
    std::swap(boxes_, sorted_);
    std::swap(owner_, next_owner_);
  }

  Device device_;
  Buffer<BoxedPrimitive> boxes_, sorted_;
  Buffer<BinaryNode> nodes_;
  Buffer<std::uint32_t> owner_, next_owner_, active_;
};

}  // namespace

std::optional<BinaryTree> binary_tree(const Device& device, Buffer<BoxedPrimitive> boxes, const Box3f& box) {
  Rounds rounds(device, std::move(boxes), box);
  if (!rounds.run()) return std::nullopt;
  return std::move(rounds).take();
}

}  // namespace gabarit
