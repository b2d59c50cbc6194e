// How the outward normal turns from one face to the next across an edge.
#pragma once

#include <optional>

#include "model/brep_curvature.h"

namespace gabarit {

// A point of an edge as one of its faces sees it.
struct EdgeSide {
  FaceId face = no_number;
  Parameters at;
  bool known = false;
};

// Radians, positive where the edge is convex; `along` runs along the edge with the face of `a` on its left,
// seen from outside. Nothing where a side is not known or has no normal.
inline std::optional<double> turn_between(const Vec3d& a, const Vec3d& b, const Vec3d& along) {
  if (a == Vec3d{} || b == Vec3d{}) return std::nullopt;
  const Vec3d axis = cross(a, b);
  const double angle = std::atan2(length(axis), dot(a, b));
  // A knife's edge and a slit look alike from here: the dangerous one is assumed.
  const bool either_way = angle > 3.14159;
  return dot(axis, along) < 0 && !either_way ? -angle : angle;
}

inline Vec3d normal_at(const BrepView& brep, FaceId face, Parameters at) {
  const Face& f = brep.faces[face];
  return outward_normal(face_point(brep, f, at), f.sign);
}

inline std::optional<double> turn_across(const BrepView& brep, const EdgeSide& a, const EdgeSide& b,
                                         const Vec3d& along) {
  if (!a.known || !b.known) return std::nullopt;
  return turn_between(normal_at(brep, a.face, a.at), normal_at(brep, b.face, b.at), along);
}

inline EdgeKind kind_of_turn(double least, double greatest) {
  const bool convex = greatest > smooth_turn, concave = least < -smooth_turn;
  if (convex && concave) return EdgeKind::mixed;
  return convex ? EdgeKind::convex : concave ? EdgeKind::concave : EdgeKind::smooth;
}

}  // namespace gabarit
