#include "gpu/normal_cone.h"
#include "gpu/parallel_for.h"
#include "gpu/tree_cones.h"

namespace gabarit {
namespace {

// Of all that lies below a child.
struct Below {
  NormalSum normals;
  std::uint32_t count;
  std::uint32_t offset, cone;  // ordered floats
};

struct ClearBelow {
  View<Below> below;

  GABARIT_HD void operator()(std::int64_t i) const {
    const float none = std::numeric_limits<float>::infinity();
    below[i] = {{}, 0, ordered(none), ordered(round_down(1 - 1e-6))};
  }
};

// use(8 * node + child) for every child that the primitive lies below.
template <class Use>
GABARIT_HD void for_each_above(View<const std::uint32_t> home, View<const std::uint32_t> parent,
                               std::int64_t primitive, Use&& use) {
  for (std::uint32_t place = home[primitive]; place != root_parent; place = parent[place / 8]) use(place);
}

struct SumNormals {
  View<const Primitive> primitives;
  View<const ContactCap> caps;
  View<const std::uint32_t> home, parent;
  View<Below> below;

  GABARIT_HD void operator()(std::int64_t i) const {
    const Vec3f normal = cap_of(primitives[i], caps).axis;
    for_each_above(home, parent, i, [&](std::uint32_t place) {
      below[place].normals.add_shared(normal);
      fetch_add(below[place].count, 1);
    });
  }
};

struct TakeMeans {
  View<const Below> below;
  View<BvhNode> nodes;

  GABARIT_HD void operator()(std::int64_t i) const {
    const Vec3f axis = mean_normal(below[i].normals, below[i].count);
    for (int k = 0; k < 3; ++k) nodes[i / 8].axis[k][i % 8] = axis[k];
  }
};

struct Narrow {
  View<const Primitive> primitives;
  View<const ContactCap> caps;
  View<const Vec3d> points;
  Vec3d origin;
  View<const std::uint32_t> home, parent;
  View<const BvhNode> nodes;
  View<Below> below;

  GABARIT_HD void operator()(std::int64_t i) const {
    const Primitive p = primitives[i];
    for_each_above(home, parent, i, [&](std::uint32_t place) {
      const BvhNode& node = nodes[place / 8];
      const std::uint32_t k = place % 8;
      const Vec3d axis{static_cast<double>(node.axis[0][k]), static_cast<double>(node.axis[1][k]),
                       static_cast<double>(node.axis[2][k])};
      if (axis == Vec3d{}) return;
      const NormalCone cone = cone_of(p, cap_of(p, caps), points.data, origin, axis);
      lower_shared(below[place].offset, ordered(cone.offset));
      lower_shared(below[place].cone, ordered(cone.cosine));
    });
  }
};

struct Write {
  View<const Below> below;
  View<BvhNode> nodes;

  GABARIT_HD void operator()(std::int64_t i) const {
    BvhNode& node = nodes[i / 8];
    const std::int64_t k = i % 8;
    if (node.child[k] == no_child) return;
    const bool any = node.axis[0][k] == 0 && node.axis[1][k] == 0 && node.axis[2][k] == 0;
    node.offset[k] = any ? 0 : from_ordered(below[i].offset);
    node.cone[k] = any ? -1 : from_ordered(below[i].cone);
  }
};

}  // namespace

void add_cones_there(const Device& device, View<const Primitive> primitives, View<const ContactCap> caps,
                     View<const Vec3d> points, const Vec3d& origin, WideTree& tree) {
  const std::int64_t children = 8 * tree.nodes.size();
  auto below = Buffer<Below>::of_size(device, children);
  const View<const Below> found = std::as_const(below).view();
  const View<const std::uint32_t> home = std::as_const(tree.home).view(),
                                  parent = std::as_const(tree.parent).view();
  parallel_for(device, children, ClearBelow{below.view()});
  parallel_for(device, primitives.size, SumNormals{primitives, caps, home, parent, below.view()});
  parallel_for(device, children, TakeMeans{found, tree.nodes.view()});
  parallel_for(
      device, primitives.size,
      Narrow{primitives, caps, points, origin, home, parent, std::as_const(tree.nodes).view(), below.view()});
  parallel_for(device, children, Write{found, tree.nodes.view()});
}

}  // namespace gabarit
