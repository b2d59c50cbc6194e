// Normals and curvatures on the faces of a Brep, seen from outside.
#pragma once

#include "model/brep_surface.h"

namespace gabarit {

// Outward unit normal; zero where the surface has none (a pole, an apex).
GABARIT_HD inline Vec3d outward_normal(const SurfacePoint& s, double sign) {
  const Vec3d n = cross(s.du, s.dv);
  const double scale = squared_length(s.du) * squared_length(s.dv);
  if (!(squared_length(n) > 1e-20 * scale) || !(scale > 0)) return {};
  return n * (sign / length(n));
}

// In 1/mm, positive where the surface is rounded like a ball seen from outside. Both zero where the normal
// is.
struct PrincipalCurvatures {
  double greatest = 0, least = 0;
};

GABARIT_HD inline PrincipalCurvatures principal_curvatures(const SurfacePoint& s, double sign) {
  const Vec3d n = outward_normal(s, sign);
  const double e = dot(s.du, s.du), f = dot(s.du, s.dv), g = dot(s.dv, s.dv);
  const double area = e * g - f * f;
  if (n == Vec3d{} || !(area > 0)) return {};
  const double l = -dot(s.duu, n), m = -dot(s.duv, n), k = -dot(s.dvv, n);
  const double mean = (e * k - 2 * f * m + g * l) / (2 * area);
  // The half difference in an orthonormal frame: no cancellation where the two are nearly equal.
  const double root = std::sqrt(area);
  const double a = l / e, b = (m - l * f / e) / root;
  const double c = (k * e - 2 * m * f + l * f * f / e) / area;
  const double half = std::sqrt((a - c) * (a - c) / 4 + b * b);
  return {mean + half, mean - half};
}

}  // namespace gabarit
