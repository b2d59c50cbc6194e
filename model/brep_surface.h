// Points and derivatives on the surfaces of a Brep.
#pragma once

#include "model/brep_curve.h"

namespace gabarit {

struct SurfacePoint {
  Vec3d p, du, dv, duu, duv, dvv;
};

// origin + rho·e(u) + h·z for a profile (rho, h) that depends on v: cylinder, cone, sphere, torus.
struct ProfilePoint {
  double rho, d_rho, dd_rho, h, d_h, dd_h;
};

GABARIT_HD inline ProfilePoint profile_point(const Surface& s, double v) {
  switch (s.kind) {
    case SurfaceKind::cone: {
      const auto [sine, cosine] = sine_cosine(s.minor);
      return {s.radius + v * sine, sine, 0, v * cosine, cosine, 0};
    }
    case SurfaceKind::sphere: {
      const auto [sine, cosine] = sine_cosine(v);
      const double x = s.radius * cosine, y = s.radius * sine;
      return {x, -y, -x, y, x, -y};
    }
    case SurfaceKind::torus: {
      const auto [sine, cosine] = sine_cosine(v);
      const double x = s.minor * cosine, y = s.minor * sine;
      return {s.radius + x, -y, -x, y, x, -y};
    }
    default: return {s.radius, 0, 0, v, 1, 0};
  }
}

GABARIT_HD inline SurfacePoint turned_profile(const Surface& s, double u, double v) {
  const ProfilePoint f = profile_point(s, v);
  const auto [sine, cosine] = sine_cosine(u);
  const Vec3d e = s.axes.x * cosine + s.axes.y * sine, de = s.axes.y * cosine - s.axes.x * sine;
  return {s.axes.origin + e * f.rho + s.axes.z * f.h,
          de * f.rho,
          e * f.d_rho + s.axes.z * f.d_h,
          e * -f.rho,
          de * f.d_rho,
          e * f.dd_rho + s.axes.z * f.dd_h};
}

GABARIT_HD inline SurfacePoint revolution_point(const BrepView& brep, const Surface& s, double u, double v) {
  const CurvePoint c = curve_point(brep, brep.curves[s.curve], v);
  const SineCosine angle = sine_cosine(u);
  const double cosine = angle.cosine, sine = angle.sine;
  const Vec3d z = s.axes.z;
  const auto turn = [&](const Vec3d& a) {
    return z * (dot(a, z) * (1 - cosine)) + a * cosine + cross(z, a) * sine;
  };
  const auto turn_d = [&](const Vec3d& a) {
    return z * (dot(a, z) * sine) - a * sine + cross(z, a) * cosine;
  };
  const Vec3d arm = c.p - s.axes.origin, flat = arm - z * dot(arm, z);
  return {s.axes.origin + turn(arm), turn_d(flat), turn(c.d), -turn(flat), turn_d(c.d), turn(c.dd)};
}

GABARIT_SEPARATE GABARIT_HD inline SurfacePoint spline_surface_point(const BrepView& brep, const Surface& s,
                                                                     double u, double v) {
  SplineBasis bu, bv;
  spline_basis(brep.knots.data + s.first_u_knot, s.u_degree, s.u_poles, u, bu);
  spline_basis(brep.knots.data + s.first_v_knot, s.v_degree, s.v_poles, v, bv);
  Pole a{0, 0, 0, 0}, au = a, av = a, auu = a, auv = a, avv = a;
  for (int i = 0; i <= s.u_degree; ++i) {
    Pole row{0, 0, 0, 0}, row_v = row, row_vv = row;
    const std::int64_t first = s.first_pole + std::int64_t{bu.first + i} * s.v_poles + bv.first;
    for (int j = 0; j <= s.v_degree; ++j) {
      const Pole& pole = brep.poles[first + j];
      add_scaled(row, pole, bv.value[j]);
      add_scaled(row_v, pole, bv.d1[j]);
      add_scaled(row_vv, pole, bv.d2[j]);
    }
    add_scaled(a, row, bu.value[i]), add_scaled(av, row_v, bu.value[i]), add_scaled(avv, row_vv, bu.value[i]);
    add_scaled(au, row, bu.d1[i]), add_scaled(auv, row_v, bu.d1[i]), add_scaled(auu, row, bu.d2[i]);
  }
  SurfacePoint r;
  r.p = numerator(a) / a.w;
  r.du = (numerator(au) - r.p * au.w) / a.w;
  r.dv = (numerator(av) - r.p * av.w) / a.w;
  r.duu = (numerator(auu) - r.du * (2 * au.w) - r.p * auu.w) / a.w;
  r.duv = (numerator(auv) - r.du * av.w - r.dv * au.w - r.p * auv.w) / a.w;
  r.dvv = (numerator(avv) - r.dv * (2 * av.w) - r.p * avv.w) / a.w;
  return r;
}

GABARIT_SEPARATE GABARIT_HD inline SurfacePoint surface_point(const BrepView& brep, const Surface& s,
                                                              double u, double v) {
  if (s.u_periodic) u = wrapped(u, s.domain.u0, s.domain.u1);
  if (s.v_periodic) v = wrapped(v, s.domain.v0, s.domain.v1);
  switch (s.kind) {
    case SurfaceKind::plane: break;
    case SurfaceKind::extrusion: {
      const CurvePoint c = curve_point(brep, brep.curves[s.curve], u);
      return {c.p + s.axes.z * v, c.d, s.axes.z, c.dd, {}, {}};
    }
    case SurfaceKind::revolution: return revolution_point(brep, s, u, v);
    case SurfaceKind::spline: return spline_surface_point(brep, s, u, v);
    default: return turned_profile(s, u, v);
  }
  return {s.axes.origin + s.axes.x * u + s.axes.y * v, s.axes.x, s.axes.y, {}, {}, {}};
}

// Where the point a·A + b·B + c·C of a facet ABC (a + b + c = 1) lies on the surface, nearly. Towards a pole
// the parameter that means nothing there stays that of the opposite side.
GABARIT_HD inline Parameters parameters_at(const FacetOrigin& facet, double a, double b, double c) {
  const double w[3] = {a, b, c};
  const Parameters* const p = facet.corners.data();
  double u = 0, v = 0, of_u = 0, of_v = 0;
  for (int i = 0; i < 3; ++i) {
    if (i != facet.u_pole) u += w[i] * p[i].u, of_u += w[i];
    if (i != facet.v_pole) v += w[i] * p[i].v, of_v += w[i];
  }
  if (of_u > 0) u /= of_u;
  if (of_v > 0) v /= of_v;
  return {of_u > 0 ? u : p[facet.u_pole].u, of_v > 0 ? v : p[facet.v_pole].v};
}

GABARIT_HD inline SurfacePoint face_point(const BrepView& brep, const Face& face, Parameters at) {
  return surface_point(brep, brep.surfaces[face.surface], at.u, at.v);
}

}  // namespace gabarit
