#include <algorithm>

#include "gpu/bvh_build.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

struct Cone {
  Vec3f axis;
  float offset = 0;
  float cosine = -1;
};

Vec3d to_double(const Vec3f& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// Zero when the normals have no common side: no cone and no half-space will help then.
Vec3f mean_normal(std::span<const Primitive> primitives) {
  Vec3d sum;
  for (const Primitive& p : primitives) sum += to_double(p.normal);
  if (length(sum) < 0.2 * static_cast<double>(primitives.size())) return {};
  const Vec3d axis = normalized(sum);
  return {static_cast<float>(axis.x), static_cast<float>(axis.y), static_cast<float>(axis.z)};
}

Cone cone_around(const FacetSurface& surface, std::span<const Primitive> primitives, const Vec3d& origin) {
  Cone cone;
  cone.axis = mean_normal(primitives);
  if (cone.axis == Vec3f{}) return cone;
  const Vec3d axis = to_double(cone.axis);
  double least = std::numeric_limits<double>::infinity();
  double cosine = 1;
  for (const Primitive& p : primitives) {
    for (std::size_t i = 0; i < (p.is_facet() ? 3U : 2U); ++i)
      least = std::min(least, dot(axis, surface.points[p.corner[i]] - origin) - static_cast<double>(p.sag));
    cosine = p.is_facet() ? std::min(cosine, dot(axis, to_double(p.normal))) : -1;
  }
  cone.offset = round_down(least);
  cone.cosine = cosine > 0 ? round_down(cosine - 1e-6) : -1;  // a cone wider than a half-space culls nothing
  return cone;
}

}  // namespace

void add_cones(const Device& device, const FacetSurface& surface, const Vec3d& origin, SplitTree& tree) {
  const std::span<const Primitive> all(surface.primitives);
  parallel_for_cpu(
      device, static_cast<std::int64_t>(tree.nodes.size()),
      [&](std::int64_t n) {
        BvhNode& node = tree.nodes[static_cast<std::size_t>(n)];
        for (int i = 0; i < tree_width; ++i) {
          if (node.child[i] == no_child) continue;
          const PrimitiveRange range = tree.ranges[static_cast<std::size_t>(n)][static_cast<std::size_t>(i)];
          const Cone cone = cone_around(surface, all.subspan(range.begin, range.end - range.begin), origin);
          for (int k = 0; k < 3; ++k) node.axis[k][i] = cone.axis[k];
          node.offset[i] = cone.offset;
          node.cone[i] = cone.cosine;
        }
      },
      16);
}

}  // namespace gabarit
