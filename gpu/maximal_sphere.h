// The largest ball on one side of a surface that touches it at a given point: half the thickness there.
// One best-first descent of the tree gives it; nothing is iterated.
// After Inui, Umezu & Shimane, Shrinking sphere: A parallel algorithm for computing the thickness of 3D
// objects (2016), with contacts separated from the query by an angle as in the literature of the medial axis.
#pragma once

#include <span>

#include "gpu/bvh.h"

namespace gabarit {

struct SphereQuery {
  Vec3d point;
  Vec3d direction;               // unit, towards the centre of the ball
  std::uint32_t own = no_child;  // primitive that is not a contact
  float sag = 0;                 // how far the true surface may lie from the point
  float spacing = 0;             // the point stands for the plane surface up to so far away
  float tilt = 0;                // by how much the true direction may turn away, radians; under 0.5
};

struct SphereOptions {
  double cos_separation = 1;  // a contact's normal turns away from the query's by at least this angle
  // Larger balls are not looked for; at most four times the half diagonal of the surface.
  double greatest_radius = std::numeric_limits<double>::infinity();
  double contact_floor = 0;  // contacts this close to the point are not contacts
};

struct SphereContact {
  static constexpr std::uint32_t none = no_child;

  double radius = std::numeric_limits<double>::infinity();
  double lower = 0;  // holds for the true surface within the sags, the tilt and the spacing
  double upper = std::numeric_limits<double>::infinity();  // holds at the point, within the sags and the tilt
  Vec3d contact;
  std::uint32_t primitive = none;  // id; none: no contact up to the greatest radius
};

// Answers are written in the order of the queries; neighbouring queries should lie close together. Where
// thousands of contacts nearly tie, as inside a finely meshed sphere, the search settles for a radius at most
// 1 % too large; the lower bound tells.
void maximal_spheres(const Bvh& tree, const SphereOptions& options, std::span<const SphereQuery> queries,
                     std::span<SphereContact> contacts);

}  // namespace gabarit
