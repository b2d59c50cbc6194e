// In which directions a ball can leave an edge or a vertex: those on the positive side of its fan.
#pragma once

#include <vector>

#include "gpu/bvh.h"

namespace gabarit {

// The outward normals of all contacts lie within the cap. Cosine -1 and no axis: nothing is known.
struct ContactCap {
  Vec3f axis;  // unit
  float cosine = -1;
};

// What maximal_spheres lets pass of a contact on the wrong side of a direction.
constexpr double fan_tolerance = 1e-5;

// Contacts lie on the positive side of each of two directions: in the plane of the two that is an arc about
// their sum, as wide as they bend. Where the mesh bends finely it stands for a surface, on which contacts may
// turn farther: the arc counts twice as wide.
struct ContactArc {
  double sine_of_half = 0, cosine_of_half = 1;  // of the bend, as it is
  double sine = 0, cosine = 1;                  // of half the arc, as it counts

  GABARIT_HD explicit ContactArc(const Vec3d& sum) : sine_of_half(0.5 * length(sum)) {
    cosine_of_half = std::sqrt(sine_of_half < 1 ? 1 - sine_of_half * sine_of_half : 0.0);
    const bool fine = sine_of_half < 0.5;
    sine = fine ? 2 * sine_of_half * cosine_of_half : sine_of_half;
    cosine = fine ? 1 - 2 * sine_of_half * sine_of_half : cosine_of_half;
  }
  // Directions that are opposite but for rounding, or the same, bound nothing.
  GABARIT_HD bool bounds() const { return sine_of_half > 0.02 && sine_of_half < 1; }
};

// By fan, as wide as arcs count; none when no fan has a direction, unknown where several primitives name one
// fan. Contacts on an edge fill an arc across it,
// those on a vertex a convex polygon on the unit sphere.
std::vector<ContactCap> contact_caps(const Device& device, const FacetSurface& surface);

// Of a facet its normal alone.
GABARIT_HD inline ContactCap cap_of(const Primitive& p, View<const ContactCap> caps) {
  if (p.is_facet()) return {p.normal, 1};
  return p.corner[2] < caps.size ? caps[p.corner[2]] : ContactCap{};
}

}  // namespace gabarit
