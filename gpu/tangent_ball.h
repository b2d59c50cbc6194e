// The ball that is tangent at the origin to the plane across a unit direction d, has its centre at t d and
// passes through a point q: t = |q|² / (2 d·q). Inversion at the origin turns the smallest t over a segment
// or triangle into a linear maximum, so each has a closed form.
#pragma once

#include <limits>

#include "gpu/vec3.h"

namespace gabarit {

struct TangentBall {
  double radius = std::numeric_limits<double>::infinity();  // infinite: nothing lies ahead
  Vec3d contact;
};

GABARIT_HD inline TangentBall ball_through_point(const Vec3d& d, const Vec3d& q) {
  const double ahead = dot(d, q);
  if (!(ahead > 0)) return {};
  return {squared_length(q) / (2 * ahead), q};
}

// `at` gets the place along the segment, 0 and 1 at its ends. Where the maximum of d·q / |q|² lies outside,
// the nearer end is the answer.
GABARIT_HD inline TangentBall ball_through_segment(const Vec3d& d, const Vec3d& a, const Vec3d& b,
                                                   double* at = nullptr) {
  const Vec3d e = b - a;
  const double a0 = dot(d, a), a1 = dot(d, e);
  const double b0 = squared_length(a), b1 = dot(a, e), b2 = squared_length(e);
  if (!(a0 > 0) && !(a0 + a1 > 0)) return {};
  double s = 0;
  if (b2 > 0) {
    const double c = (a1 * b0 - 2 * a0 * b1) / b2;
    const double root = std::sqrt(a0 * a0 + a1 * c > 0 ? a0 * a0 + a1 * c : 0.0);
    s = a0 > 0 ? c / (a0 + root) : (root - a0) / a1;
    s = s > 0 ? (s < 1 ? s : 1.0) : 0.0;
  }
  if (at != nullptr) *at = s;
  return ball_through_point(d, s == 1 ? b : a + s * e);
}

// Gives up, with an infinite radius, once the answer is sure to be above `limit`. A triangle without a normal
// has no plane: nothing is found.
GABARIT_HD inline TangentBall ball_through_triangle(const Vec3d& d, const Vec3d& a, const Vec3d& b,
                                                    const Vec3d& c, double limit) {
  const Vec3d ab = b - a, bc = c - b, ca = a - c;
  const Vec3d raw = cross(ca, ab);
  const double area = length(raw);
  if (!(area > 0)) return {};
  double h = dot(raw, a);
  Vec3d n = raw;
  if (h < 0) h = -h, n = -n;  // n, as long as the area, points from the origin to the plane
  const double spread = area + dot(n, d);
  bool beyond_ab = true, beyond_bc = true, beyond_ca = true;
  if (spread > 0) {
    const double t = h / spread;
    if (t > limit) return {};
    const Vec3d p = t * (area * d + n);  // area times the contact
    beyond_ab = dot(cross(ab, p - area * a), raw) < 0;
    beyond_bc = dot(cross(bc, p - area * b), raw) < 0;
    beyond_ca = dot(cross(ca, p - area * c), raw) < 0;
    if (!beyond_ab && !beyond_bc && !beyond_ca) return {t, p / area};
  }
  // Balls cut the plane in nested disks: the smallest that reaches the triangle does so at an edge that the
  // smallest of all lies beyond.
  TangentBall best;
  if (beyond_ab) best = ball_through_segment(d, a, b);
  if (beyond_bc) {
    const TangentBall other = ball_through_segment(d, b, c);
    if (other.radius < best.radius) best = other;
  }
  if (beyond_ca) {
    const TangentBall other = ball_through_segment(d, c, a);
    if (other.radius < best.radius) best = other;
  }
  return best;
}

}  // namespace gabarit
