// Parameters on a face: how far they may go, and those of the place nearest to a point.
#pragma once

#include "model/brep_surface.h"

namespace gabarit {

// Where the parameters may go: over the ends of the face's range by its width, for what is looked for may lie
// outside the trimming curves and come back; never off the surface itself.
GABARIT_HD inline Parameters kept_on_surface(const Surface& surface, const Face& face, Parameters p) {
  const ParameterBox& r = face.range;
  const double width = r.u1 - r.u0, height = r.v1 - r.v0;
  const auto between = [](double x, double low, double high) { return x < low ? low : x > high ? high : x; };
  if (!surface.u_periodic) {
    p.u = between(p.u, r.u0 - width, r.u1 + width);
    p.u = between(p.u, surface.domain.u0, surface.domain.u1);
  }
  if (!surface.v_periodic) {
    p.v = between(p.v, r.v0 - height, r.v1 + height);
    p.v = between(p.v, surface.domain.v0, surface.domain.v1);
  }
  return p;
}

// The parameters of the point of the surface that is nearest to p, from `at` on; Gauss and Newton.
GABARIT_HD inline Parameters nearest_parameters(const BrepView& brep, const Face& face, const Vec3d& p,
                                                Parameters at) {
  const Surface& surface = brep.surfaces[face.surface];
  SurfacePoint s = face_point(brep, face, at);
  for (int i = 0; i < 20; ++i) {
    const Vec3d r = p - s.p;
    const double a = dot(s.du, s.du), b = dot(s.du, s.dv), c = dot(s.dv, s.dv), area = a * c - b * b;
    if (!(area > 1e-24 * a * c)) break;
    const double ru = dot(r, s.du), rv = dot(r, s.dv);
    const Parameters next =
        kept_on_surface(surface, face, {at.u + (c * ru - b * rv) / area, at.v + (a * rv - b * ru) / area});
    const SurfacePoint there = face_point(brep, face, next);
    if (!(squared_length(p - there.p) < squared_length(r))) break;
    at = next, s = there;
  }
  return at;
}

}  // namespace gabarit
