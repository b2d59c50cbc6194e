#include "gpu/bvh.h"

#include <algorithm>
#include <stdexcept>

#include "gpu/bvh_build.h"
#include "gpu/bvh_there.h"
#include "gpu/contact_cap.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

int corners(const Primitive& p) { return p.is_facet() ? 3 : 2; }

Box3d bounds(const FacetSurface& surface) {
  Box3d box;
  for (const Primitive& p : surface.primitives) {
    for (int i = 0; i < corners(p); ++i) box.add(surface.points[p.corner[static_cast<std::size_t>(i)]]);
  }
  return box;
}

std::vector<BoxedPrimitive> boxed(const Device& device, const FacetSurface& surface, const Vec3d& origin) {
  std::vector<BoxedPrimitive> boxes(surface.primitives.size());
  parallel_for_cpu(
      device, static_cast<std::int64_t>(boxes.size()),
      [&](std::int64_t i) {
        const auto k = static_cast<std::size_t>(i);
        boxes[k] = boxed_primitive(surface.primitives[k], surface.points.data(), origin,
                                   static_cast<std::uint32_t>(i));
      },
      16384);
  return boxes;
}

void reorder(FacetSurface& surface, const std::vector<BoxedPrimitive>& order) {
  std::vector<Primitive> sorted(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = surface.primitives[order[i].primitive];
  surface.primitives = std::move(sorted);
}

// Numbers the points in the order in which the tree meets them: neighbours share cache lines.
void renumber_points(FacetSurface& surface) {
  constexpr std::uint32_t unset = 0xffffffffU;
  std::vector<std::uint32_t> number(surface.points.size(), unset);
  std::vector<Vec3d> points;
  points.reserve(surface.points.size());
  for (Primitive& p : surface.primitives) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(corners(p)); ++i) {
      std::uint32_t& n = number[p.corner[i]];
      if (n == unset)
        n = static_cast<std::uint32_t>(points.size()), points.push_back(surface.points[p.corner[i]]);
      p.corner[i] = n;
    }
  }
  surface.points = std::move(points);
}

}  // namespace

Bvh::Bvh(const Device& device, FacetSurface surface) : device_(device) {
  if (surface.primitives.size() >= (std::size_t{1} << 28))
    throw std::length_error("more than 268 million facets are too many for one tree");
  const Box3d box = bounds(surface);
  if (!box.empty()) origin_ = box.centre();
  reach_ = round_up(length(box.extent()) * 0.5);
  for (const Primitive& p : surface.primitives) greatest_sag_ = std::max(greatest_sag_, p.sag);
  const std::vector<ContactCap> caps = contact_caps(device, surface);
  fan_first_ = {device, std::move(surface.fan_first)};
  fan_directions_ = {device, std::move(surface.fan_directions)};
  if (!device.has_own_memory() || !take(build_there(device, surface, caps, origin_)))
    build_here(surface, caps);
}

bool Bvh::take(std::optional<TreeThere> tree) {
  if (!tree) return false;
  nodes_ = std::move(tree->nodes);
  leaves_ = std::move(tree->leaves);
  primitives_ = std::move(tree->primitives);
  points_ = std::move(tree->points);
  return true;
}

void Bvh::build_here(FacetSurface& surface, const std::vector<ContactCap>& caps) {
  std::vector<BoxedPrimitive> boxes = boxed(device_, surface, origin_);
  SplitTree tree = split_into_nodes(device_, boxes);
  reorder(surface, boxes);
  boxes = {};
  renumber_points(surface);
  add_cones(device_, surface, caps, origin_, tree);
  nodes_ = {device_, std::move(tree.nodes)};
  leaves_ = {device_, std::move(tree.leaves)};
  primitives_ = {device_, std::move(surface.primitives)};
  points_ = {device_, std::move(surface.points)};
}

BvhView Bvh::view() const {
  return {nodes_.view(),
          leaves_.view(),
          primitives_.view(),
          points_.view(),
          fan_first_.view(),
          fan_directions_.view(),
          origin_,
          reach_,
          greatest_sag_};
}

std::vector<std::uint32_t> Bvh::order() const {
  std::vector<Primitive> primitives(static_cast<std::size_t>(primitives_.view().size));
  primitives_.read(primitives);
  std::vector<std::uint32_t> order;
  order.reserve(primitives.size());
  for (const Primitive& p : primitives) order.push_back(p.id);
  return order;
}

std::size_t Bvh::bytes() const {
  return nodes_.bytes() + leaves_.bytes() + primitives_.bytes() + points_.bytes() + fan_first_.bytes() +
         fan_directions_.bytes();
}

}  // namespace gabarit
