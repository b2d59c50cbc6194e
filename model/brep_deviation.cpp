#include "model/brep_deviation.h"

#include <algorithm>

#include "gpu/triangle.h"
#include "model/brep_surface.h"

namespace gabarit {
namespace {

struct Weights {
  double a, b, c;
};
constexpr std::array<Weights, 10> places{{{1 / 3., 1 / 3., 1 / 3.},
                                          {.5, .5, 0},
                                          {.5, 0, .5},
                                          {0, .5, .5},
                                          {.5, .25, .25},
                                          {.25, .5, .25},
                                          {.25, .25, .5},
                                          {.7, .15, .15},
                                          {.15, .7, .15},
                                          {.15, .15, .7}}};

// closest_point divides by the area: for facets without height the sides will do.
Vec3d nearest(const Vec3d& p, const std::array<Vec3d, 3>& c) {
  const Vec3d u = c[1] - c[0], v = c[2] - c[0];
  if (squared_length(cross(u, v)) > 1e-20 * squared_length(u) * squared_length(v))
    return closest_point(p, c[0], c[1], c[2]);
  Vec3d best = c[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d along = c[(i + 1) % 3] - c[i];
    const double t = std::clamp(dot(p - c[i], along) / squared_length(along), 0.0, 1.0);
    const Vec3d q = c[i] + along * t;
    if (squared_length(p - q) < squared_length(p - best)) best = q;
  }
  return best;
}

// Squared distance from x to the surface near `at`: a few steps of Gauss and Newton, the best of them.
double squared_distance(const BrepView& brep, const Face& face, Parameters at, const Vec3d& x) {
  double best = squared_length(face_point(brep, face, at).p - x);
  for (int step = 0; step < 4; ++step) {
    const SurfacePoint s = face_point(brep, face, at);
    const double e = dot(s.du, s.du), f = dot(s.du, s.dv), g = dot(s.dv, s.dv), area = e * g - f * f;
    if (!(area > 0)) break;
    const double a = dot(s.du, x - s.p), b = dot(s.dv, x - s.p);
    at.u += (g * a - f * b) / area, at.v += (e * b - f * a) / area;
    const double distance = squared_length(face_point(brep, face, at).p - x);
    if (!(distance < best)) break;
    best = distance;
  }
  return best;
}

// Squared; never less than `known`. The parameters between the corners of a long facet may lead away from it:
// a point that seems far off is looked at again, from the facet to the surface.
double facet_deviation(const BrepView& brep, const FacetOrigin& origin, const std::array<Vec3d, 3>& corners,
                       double known) {
  const Face& face = brep.faces[origin.face];
  if (brep.surfaces[face.surface].kind == SurfaceKind::plane) return known;
  for (const Weights& w : places) {
    const Parameters at = parameters_at(origin, w.a, w.b, w.c);
    const Vec3d p = face_point(brep, face, at).p;
    const double seen = squared_length(p - nearest(p, corners));
    if (seen <= known) continue;
    const Vec3d x = corners[0] * w.a + corners[1] * w.b + corners[2] * w.c;
    known = std::max(known, std::min(seen, squared_distance(brep, face, at, x)));
  }
  return known;
}

}  // namespace

void settle_poles(const Brep& brep, FacetOrigin& facet) {
  const BrepView arrays = view(brep);
  const Face& face = brep.faces[facet.face];
  const Surface& surface = brep.surfaces[face.surface];
  const SurfaceKind kind = surface.kind;
  // A hair beyond a pole the normal is the opposite one.
  for (Parameters& corner : facet.corners) {
    if (!surface.u_periodic) corner.u = std::clamp(corner.u, surface.domain.u0, surface.domain.u1);
    if (!surface.v_periodic) corner.v = std::clamp(corner.v, surface.domain.v0, surface.domain.v1);
  }
  if (kind == SurfaceKind::plane || kind == SurfaceKind::cylinder || kind == SurfaceKind::torus) return;
  const std::array<Parameters, 3> corners = facet.corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Parameters &b = corners[(i + 1) % 3], &c = corners[(i + 2) % 3];
    const SurfacePoint here = face_point(arrays, face, corners[i]);
    const SurfacePoint there = face_point(arrays, face, b);
    // 1e-6: what a file's apex is off by; a facet there is a thousand times larger.
    if (squared_length(here.du) <= 1e-12 * squared_length(there.du))
      facet.u_pole = static_cast<std::int8_t>(i), facet.corners[i].u = (b.u + c.u) / 2;
    if (squared_length(here.dv) <= 1e-12 * squared_length(there.dv))
      facet.v_pole = static_cast<std::int8_t>(i), facet.corners[i].v = (b.v + c.v) / 2;
  }
}

double greatest_deviation(const Brep& brep, const TriangleMesh& mesh, FacetId first, FacetId last) {
  const BrepView arrays = view(brep);
  double greatest = 0;  // squared
  for (FacetId f = first; f < last; ++f) {
    if (brep.facets[f].face == no_number) continue;
    greatest = facet_deviation(arrays, brep.facets[f], mesh.corners(f), greatest);
  }
  return std::sqrt(greatest);
}

}  // namespace gabarit
