#include <algorithm>

#include "gpu/bvh_build.h"
#include "gpu/normal_cone.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

struct Cone {
  Vec3f axis;
  float offset = 0;
  float cosine = -1;
};

Cone cone_around(const FacetSurface& surface, View<const ContactCap> caps,
                 std::span<const Primitive> primitives, const Vec3d& origin) {
  Cone cone;
  NormalSum normals;
  for (const Primitive& p : primitives) normals.add(cap_of(p, caps).axis);
  cone.axis = mean_normal(normals, static_cast<std::uint32_t>(primitives.size()));
  if (cone.axis == Vec3f{}) return cone;
  const Vec3d axis = to_double(cone.axis);
  cone.offset = std::numeric_limits<float>::infinity();
  cone.cosine = round_down(1 - 1e-6);
  for (const Primitive& p : primitives) {
    const NormalCone own = cone_of(p, cap_of(p, caps), surface.points.data(), origin, axis);
    cone.offset = std::min(cone.offset, own.offset);
    cone.cosine = std::min(cone.cosine, own.cosine);
  }
  return cone;
}

}  // namespace

void add_cones(const Device& device, const FacetSurface& surface, const std::vector<ContactCap>& caps,
               const Vec3d& origin, SplitTree& tree) {
  const View<const ContactCap> caps_of_fans{caps.data(), static_cast<std::int64_t>(caps.size())};
  const std::span<const Primitive> all(surface.primitives);
  parallel_for_cpu(
      device, static_cast<std::int64_t>(tree.nodes.size()),
      [&](std::int64_t n) {
        BvhNode& node = tree.nodes[static_cast<std::size_t>(n)];
        for (int i = 0; i < tree_width; ++i) {
          if (node.child[i] == no_child) continue;
          const PrimitiveRange range = tree.ranges[static_cast<std::size_t>(n)][static_cast<std::size_t>(i)];
          const Cone cone =
              cone_around(surface, caps_of_fans, all.subspan(range.begin, range.end - range.begin), origin);
          for (int k = 0; k < 3; ++k) node.axis[k][i] = cone.axis[k];
          node.offset[i] = cone.offset;
          node.cone[i] = cone.cosine;
        }
      },
      16);
}

}  // namespace gabarit
