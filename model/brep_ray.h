// Where a straight line meets the surface of a face.
#pragma once

#include "model/brep_edge.h"
#include "model/brep_nearest.h"
#include "model/brep_trim.h"

namespace gabarit {

// A line with two unit vectors across it: seen along it, a point of a surface is a point of a plane.
struct RayFrame {
  Vec3d point, direction, x, y;

  GABARIT_HD RayFrame(const Vec3d& from, const Vec3d& along) : point(from), direction(along) {
    const double ax = std::fabs(along.x), ay = std::fabs(along.y), az = std::fabs(along.z);
    const Vec3d other = ax <= ay && ax <= az ? Vec3d{1, 0, 0} : ay <= az ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
    x = cross(along, other);
    x = x / length(x);
    y = cross(along, x);
  }
  // Across the line, and along it.
  GABARIT_HD Vec3d seen(const Vec3d& p) const {
    const Vec3d q = p - point;
    return {dot(q, x), dot(q, y), dot(q, direction)};
  }
};

// How far what is seen lies from the line.
GABARIT_HD inline double aside(const Vec3d& seen) { return std::sqrt(seen.x * seen.x + seen.y * seen.y); }

struct RayMeeting {
  double distance = 0;  // along the line
  double beside = 0;    // mm: how far the point of the surface is from the line
  Parameters at;
  Vec3d p, du, dv;
  bool met = false;
};

// Newton's method in (u, v) from the parameters on, halving steps until the point comes nearer to the line;
// the trimming curves are not looked at. Met when it ends within `close` of the line. Where the line touches
// the surface without crossing it the method is slow and may end short of it.
GABARIT_SEPARATE GABARIT_HD inline RayMeeting meet_surface(const BrepView& brep, const Face& face,
                                                           const RayFrame& ray, Parameters at, double close) {
  constexpr int most_steps = 30, most_halvings = 20;
  const Surface& surface = brep.surfaces[face.surface];
  SurfacePoint s = face_point(brep, face, at);
  Vec3d q = ray.seen(s.p);
  double beside = aside(q);
  for (int step = 0; step < most_steps && beside > 1e-3 * close; ++step) {
    const double xu = dot(s.du, ray.x), xv = dot(s.dv, ray.x), yu = dot(s.du, ray.y), yv = dot(s.dv, ray.y);
    const double area = xu * yv - xv * yu;
    if (!(std::fabs(area) > 1e-14 * std::sqrt(squared_length(s.du) * squared_length(s.dv)))) break;
    const double du = (xv * q.y - yv * q.x) / area, dv = (yu * q.x - xu * q.y) / area;
    double part = 1;
    bool nearer = false;
    for (int i = 0; i < most_halvings && !nearer; ++i, part /= 2) {
      const Parameters next = kept_on_surface(surface, face, {at.u + part * du, at.v + part * dv});
      const SurfacePoint there = face_point(brep, face, next);
      const Vec3d seen = ray.seen(there.p);
      const double distance = aside(seen);
      nearer = distance < beside;
      if (nearer) at = next, s = there, q = seen, beside = distance;
    }
    if (!nearer) break;
  }
  return {q.z, beside, at, s.p, s.du, s.dv, beside <= close};
}

// Whether p lies within twice the tolerance of one of the face's edges, or of an end of it.
GABARIT_HD inline bool at_an_edge(const BrepView& brep, FaceId face, const Vec3d& p) {
  for (std::uint32_t i = brep.first_edge_of_face[face]; i < brep.first_edge_of_face[face + 1]; ++i) {
    const Edge& edge = brep.edges[brep.edges_of_face[i]];
    for (const std::uint32_t v : edge.vertices)
      if (v != no_number && length(brep.vertices[v].point - p) <= 2 * brep.vertices[v].tolerance) return true;
    if (distance_to_edge(brep, edge, p) <= 2 * edge.tolerance) return true;
  }
  return false;
}

// Whether the face itself is there, or so near to its edges that their tolerance decides.
enum class Presence : std::uint8_t { absent, near, there };

// `reach` is not less than twice the tolerance of any edge or vertex of the face.
GABARIT_SEPARATE GABARIT_HD inline Presence presence(const BrepView& brep, FaceId face,
                                                     const RayMeeting& meeting, double reach) {
  const bool inside = trim_side(brep, face, meeting.at) == TrimSide::inside;
  const double along_u = length(meeting.du), along_v = length(meeting.dv);
  bool beside = false;
  // Eight directions: they need not be at right angles on the surface.
  for (int i = 0; i < 8 && !beside && along_u > 0 && along_v > 0; ++i) {
    const auto [sine, cosine] = sine_cosine(i * (3.14159265358979323846 / 4));
    const Parameters there{meeting.at.u + reach * cosine / along_u, meeting.at.v + reach * sine / along_v};
    beside = (trim_side(brep, face, there) == TrimSide::inside) != inside;
  }
  if (beside && at_an_edge(brep, face, meeting.p)) return Presence::near;
  return inside ? Presence::there : Presence::absent;
}

}  // namespace gabarit
