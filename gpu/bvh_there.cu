#include <utility>

#include "gpu/bvh_there.h"
#include "gpu/parallel_for.h"
#include "gpu/prefix_sums.h"
#include "gpu/tree_cones.h"

namespace gabarit {
namespace {

GABARIT_HD int corners_of(const Primitive& p) { return p.is_facet() ? 3 : 2; }

struct BoxPrimitives {
  View<const Primitive> primitives;
  View<const Vec3d> points;
  Vec3d origin;
  View<BoxedPrimitive> boxes;
  View<SharedBox> all;

  GABARIT_HD void operator()(std::int64_t i) const {
    const Primitive& p = primitives[i];
    boxes[i] = boxed_primitive(p, points.data, origin, static_cast<std::uint32_t>(i));
    all[0].add(boxes[i].box);
  }
};

struct ClearBox {
  View<SharedBox> all;

  GABARIT_HD void operator()(std::int64_t) const { all[0].clear(); }
};

struct Reorder {
  View<const BoxedPrimitive> boxes;
  View<const Primitive> from;
  View<Primitive> to;

  GABARIT_HD void operator()(std::int64_t i) const { to[i] = from[boxes[i].primitive]; }
};

// Points are numbered in the order in which the tree meets them: neighbours share cache lines.
struct MeetPoints {
  View<const Primitive> primitives;
  View<std::uint32_t> met;  // by point: 3 * primitive + corner, the first one

  GABARIT_HD void operator()(std::int64_t i) const {
    for (int c = 0; c < corners_of(primitives[i]); ++c)
      lower_shared(met[primitives[i].corner[static_cast<std::size_t>(c)]],
                   static_cast<std::uint32_t>(3 * i + c));
  }
};

struct MarkFirst {
  View<const Primitive> primitives;
  View<const std::uint32_t> met;
  View<std::uint32_t> is_first;

  GABARIT_HD void operator()(std::int64_t i) const {
    for (int c = 0; c < 3; ++c) {
      const bool first =
          c < corners_of(primitives[i]) &&
          met[primitives[i].corner[static_cast<std::size_t>(c)]] == static_cast<std::uint32_t>(3 * i + c);
      is_first[3 * i + c] = first ? 1 : 0;
    }
  }
};

struct Renumber {
  View<const Vec3d> from;
  View<const std::uint32_t> met, number;
  View<Primitive> primitives;
  View<Vec3d> to;

  GABARIT_HD void operator()(std::int64_t i) const {
    Primitive p = primitives[i];
    for (int c = 0; c < corners_of(p); ++c) {
      std::uint32_t& corner = p.corner[static_cast<std::size_t>(c)];
      const std::uint32_t place = met[corner];
      if (place == static_cast<std::uint32_t>(3 * i + c)) to[number[place]] = from[corner];
      corner = number[place];
    }
    primitives[i] = p;
  }
};

void renumber_points(const Device& device, const Buffer<Vec3d>& points, TreeThere& tree) {
  const std::int64_t n = tree.primitives.size();
  const View<const Primitive> primitives = std::as_const(tree.primitives).view();
  Buffer<std::uint32_t> met(device,
                            std::vector<std::uint32_t>(static_cast<std::size_t>(points.size()), no_child));
  parallel_for(device, n, MeetPoints{primitives, met.view()});
  auto is_first = Buffer<std::uint32_t>::of_size(device, 3 * n);
  parallel_for(device, n, MarkFirst{primitives, std::as_const(met).view(), is_first.view()});
  const PrefixSums numbers = prefix_sums(device, is_first);
  tree.points = Buffer<Vec3d>::of_size(device, numbers.total);
  parallel_for(device, n,
               Renumber{points.view(), std::as_const(met).view(), numbers.before.view(),
                        tree.primitives.view(), tree.points.view()});
}

std::optional<WideTree> split(const Device& device, const Buffer<Primitive>& given,
                              const Buffer<Vec3d>& points, const Vec3d& origin,
                              Buffer<BoxedPrimitive>& order) {
  auto boxes = Buffer<BoxedPrimitive>::of_size(device, given.size());
  auto all = Buffer<SharedBox>::of_size(device, 1);
  parallel_for(device, 1, ClearBox{all.view()});
  parallel_for(device, given.size(),
               BoxPrimitives{given.view(), points.view(), origin, boxes.view(), all.view()});
  std::optional<BinaryTree> binary = binary_tree(device, std::move(boxes), all.read().front().box());
  if (!binary) return std::nullopt;
  std::optional<WideTree> wide = wide_tree(device, *binary);
  order = std::move(binary->boxes);
  return wide;
}

}  // namespace

std::optional<TreeThere> build_there(const Device& device, const FacetSurface& surface,
                                     const std::vector<ContactCap>& caps, const Vec3d& origin) {
  if (surface.primitives.empty()) return TreeThere{};
  const Buffer<Primitive> given(device, surface.primitives);
  const Buffer<Vec3d> points(device, surface.points);
  Buffer<BoxedPrimitive> order;
  std::optional<WideTree> wide = split(device, given, points, origin, order);
  if (!wide) return std::nullopt;
  TreeThere tree;
  tree.primitives = Buffer<Primitive>::of_size(device, given.size());
  parallel_for(device, given.size(),
               Reorder{std::as_const(order).view(), given.view(), tree.primitives.view()});
  const Buffer<ContactCap> caps_of_fans(device, caps);
  add_cones_there(device, std::as_const(tree.primitives).view(), caps_of_fans.view(), points.view(), origin,
                  *wide);
  renumber_points(device, points, tree);
  tree.nodes = std::move(wide->nodes);
  tree.leaves = std::move(wide->leaves);
  return tree;
}

}  // namespace gabarit
