// A bounding volume hierarchy of eight children a node over facets and over the edges and vertices that a
// ball can touch. Its float boxes, half-spaces and normal cones only cull, rounded so that nothing is lost;
// whatever they let through is decided in double by the queries.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/bvh_leaf.h"
#include "gpu/vec3.h"

namespace gabarit {

// A facet has a normal. An edge or vertex has none: its ends are corner[0] and corner[1] (equal for a vertex)
// and corner[2] numbers its fan, the directions in which the surface leaves it.
struct Primitive {
  std::array<std::uint32_t, 3> corner{};  // indices of points
  std::uint32_t id = 0;                   // unique; of a facet the caller's number
  Vec3f normal;                           // unit, the side that counts as outside
  float sag = 0;                          // how far the true surface may lie from it

  GABARIT_HD bool is_facet() const { return normal.x != 0 || normal.y != 0 || normal.z != 0; }
};

// What a tree is built over. Every number is finite; there are fewer than 2^28 primitives.
struct FacetSurface {
  std::vector<Vec3d> points;
  std::vector<Primitive> primitives;
  std::vector<std::uint32_t> fan_first{0};  // one more than there are fans
  std::vector<Vec3f> fan_directions;        // unit
};

constexpr int tree_width = 8;
constexpr std::uint32_t no_child = 0xffffffffU;
constexpr std::uint32_t leaf_flag = 0x80000000U;

// The children side by side, so that one vector instruction tests eight. Coordinates are relative to
// BvhView::origin. An absent child lies infinitely far away.
struct alignas(32) BvhNode {
  float lo[3][tree_width];
  float hi[3][tree_width];
  float axis[3][tree_width];        // mean normal of the facets below, unit or zero
  float offset[tree_width];         // axis · p >= offset for every point p below
  float cone[tree_width];           // cosine of the widest angle between axis and the normal of a facet or
                                    // of a contact on an edge or vertex below; -1: any
  std::uint32_t child[tree_width];  // a node, or leaf_flag | leaf

  GABARIT_HD float low(int k, int i) const { return lo[k][i]; }
  GABARIT_HD float high(int k, int i) const { return hi[k][i]; }
};

struct BvhView {
  View<const BvhNode> nodes;  // the first is the root; none when there is no primitive
  View<const BvhLeaf> leaves;
  View<const Primitive> primitives;
  View<const Vec3d> points;
  View<const std::uint32_t> fan_first;
  View<const Vec3f> fan_directions;
  Vec3d origin;
  float reach = 0;         // greatest absolute coordinate relative to the origin
  float greatest_sag = 0;  // of any primitive; the boxes and half-spaces are wider by the sags

  GABARIT_HD Vec3d corner(const Primitive& p, int i) const {
    return points[p.corner[static_cast<std::size_t>(i)]];
  }
};

struct ContactCap;
struct TreeThere;

class Bvh {
 public:
  // Built by binned surface area heuristic (Wald, On fast Construction of SAH-based Bounding
  // Volume Hierarchies, 2007), eight children at once; the same tree for any number of threads.
  Bvh(const Device& device, FacetSurface surface);

  BvhView view() const;  // of the device's memory
  const Device& device() const { return device_; }
  std::size_t bytes() const;
  // Ids in the order of the tree: neighbours in the list are neighbours in space.
  std::vector<std::uint32_t> order() const;

 private:
  bool take(std::optional<TreeThere> tree);
  void build_here(FacetSurface& surface, const std::vector<ContactCap>& caps);

  Device device_;
  Buffer<BvhNode> nodes_;
  Buffer<BvhLeaf> leaves_;
  Buffer<Primitive> primitives_;
  Buffer<Vec3d> points_;
  Buffer<std::uint32_t> fan_first_;
  Buffer<Vec3f> fan_directions_;
  Vec3d origin_;
  float reach_ = 0, greatest_sag_ = 0;
};

}  // namespace gabarit
