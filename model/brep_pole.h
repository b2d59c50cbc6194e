// Places of a face beside its poles, where one parameter means nothing, and beside the corners of its facets.
#pragma once

#include "model/brep_foot.h"

namespace gabarit {

// How far a point moves when a parameter runs through the face's range, squared, mm².
GABARIT_HD inline Parameters extents(const Face& face, const SurfacePoint& s) {
  const ParameterBox& r = face.range;
  return {squared_length(s.du) * (r.u1 - r.u0) * (r.u1 - r.u0),
          squared_length(s.dv) * (r.v1 - r.v0) * (r.v1 - r.v0)};
}

// An apex, a pole.
GABARIT_HD inline bool is_pole(const Face& face, const SurfacePoint& s) {
  const auto [u, v] = extents(face, s);
  return u < 1e-8 * v || v < 1e-8 * u;
}

// A place right beside a pole for which `counts(Parameters)` holds: at the pole's own parameters or at one of
// 65 around it. False when there is none.
template <class Counts>
GABARIT_HD bool beside_pole(const Face& face, const FaceFoot& pole, const Counts& counts, Parameters& found) {
  const ParameterBox& r = face.range;
  const auto [u, v] = extents(face, pole.surface);
  const bool in_u = u < v;
  constexpr int places = 64;
  for (int i = -1; i <= places; ++i) {
    const double share = static_cast<double>(i) / places;
    Parameters at = pole.at;
    (in_u ? at.v : at.u) += 1e-4 * (in_u ? (r.v0 + r.v1) / 2 - at.v : (r.u0 + r.u1) / 2 - at.u);
    if (i >= 0) (in_u ? at.u : at.v) = in_u ? r.u0 + share * (r.u1 - r.u0) : r.v0 + share * (r.v1 - r.v0);
    if (counts(at)) return found = at, true;
  }
  return false;
}

// Where a point q of the facet abc lies on the surface, nearly; a little inside, as a pole has no normal.
GABARIT_HD inline Parameters parameters_of(const FacetOrigin& origin, const Vec3d& q, const Vec3d& a,
                                           const Vec3d& b, const Vec3d& c) {
  const Vec3d u = b - a, v = c - a, w = q - a;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const double area = uu * vv - uv * uv;
  double s = area > 0 ? (vv * uw - uv * vw) / area : 1 / 3.0;
  double t = area > 0 ? (uu * vw - uv * uw) / area : 1 / 3.0;
  s = s > 0 ? (s < 1 ? s : 1.0) : 0.0;
  t = t > 0 ? (s + t < 1 ? t : 1 - s) : 0.0;
  // A little inside: at a pole the surface has no normal.
  s += 1e-3 * (1 / 3.0 - s), t += 1e-3 * (1 / 3.0 - t);
  return parameters_at(origin, 1 - s - t, s, t);
}

}  // namespace gabarit
