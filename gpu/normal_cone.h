// What the normals of facets and the contacts of edges and vertices have in common: every builder of a tree
// takes the same.
#pragma once

#include "gpu/bvh_build.h"
#include "gpu/contact_cap.h"
#include "gpu/normal_sum.h"

namespace gabarit {

struct NormalCone {
  float offset, cosine;
};

GABARIT_HD inline Vec3d to_double(const Vec3f& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// Zero when the normals have no common side: no cone and no half-space will help then.
GABARIT_HD inline Vec3f mean_normal(const NormalSum& normals, std::uint32_t count) {
  const Vec3d sum = normals.value();
  if (length(sum) < 0.2 * static_cast<double>(count)) return {};
  const Vec3d axis = normalized(sum);
  return {static_cast<float>(axis.x), static_cast<float>(axis.y), static_cast<float>(axis.z)};
}

// Of the widest angle between the axis and a cap, -1 when it is no less than a right angle.
GABARIT_HD inline double cosine_to(const ContactCap& cap, const Vec3d& axis) {
  const Vec3d of_cap = to_double(cap.axis);
  const double wide = cap.cosine, size = length(of_cap);
  if (!(wide > 0) || !(size > 0)) return -1;
  const double between = dot(axis, of_cap) / size;
  if (!(between > 0)) return -1;
  const double b = between < 1 ? between : 1.0;
  const double cosine = b * wide - std::sqrt((1 - b * b) * (1 - wide * wide));
  return cosine > 0 ? cosine : -1;
}

// Of one primitive; those of several are the least of each. A cone wider than a half-space (-1) culls
// nothing.
GABARIT_HD inline NormalCone cone_of(const Primitive& p, const ContactCap& cap, const Vec3d* points,
                                     const Vec3d& origin, const Vec3d& axis) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < (p.is_facet() ? 3U : 2U); ++i) {
    const double height = dot(axis, points[p.corner[i]] - origin) - static_cast<double>(p.sag);
    least = height < least ? height : least;
  }
  const double cosine = p.is_facet() ? dot(axis, to_double(p.normal)) : cosine_to(cap, axis);
  return {round_down(least), cosine > 0 ? round_down((cosine < 1 ? cosine : 1) - 1e-6) : -1};
}

}  // namespace gabarit
