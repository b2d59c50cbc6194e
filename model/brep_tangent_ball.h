// The ball that touches a surface at O with its centre on the side of a unit direction d, and another face or
// edge at P: t = |P - O|² / (2 d·(P - O)), its radius, made least by Newton's method with second derivatives.
// After G. Lemasson, J.-C. Iehl, F. Zara, V. Baudet, P. Arthaud, B. Shariat, Accurate thickness computation
// of a B-Rep model on the GPU, WSCG 2014, whose form is of first order: without II·(P - M).
#pragma once

#include "model/brep_curvature.h"
#include "model/brep_trim.h"

namespace gabarit {

struct BallFoot {
  double radius = std::numeric_limits<double>::infinity();  // mm; infinite: P does not lie ahead
  Vec3d contact;                                            // P
  Parameters at;                                            // on the face; on an edge u is the curve's t
  double residual = 0;  // mm: how far P - M is from being across the surface (or the curve)
  int steps = 0;
};

// |P - O|² / (2 d·(P - O)); infinite when P does not lie ahead.
GABARIT_HD inline double ball_radius(const Vec3d& q, const Vec3d& d) {
  const double ahead = dot(d, q);
  return ahead > 0 ? squared_length(q) / (2 * ahead) : std::numeric_limits<double>::infinity();
}

// The gradient and Hessian of t times d·q, from the derivatives of the surface: with m = q - t d it is
// m·S_i, and S_i·S_j + m·S_ij less what the gradient itself changes.
struct BallSlope {
  double t = 0, ahead = 0;
  double gu = 0, gv = 0;
  double uu = 0, uv = 0, vv = 0;  // of first order; with `second` added, of second

  GABARIT_HD BallSlope(const SurfacePoint& s, const Vec3d& o, const Vec3d& d) {
    const Vec3d q = s.p - o;
    ahead = dot(d, q), t = ball_radius(q, d);
    const Vec3d m = q - t * d;
    gu = dot(m, s.du), gv = dot(m, s.dv);
    uu = dot(s.du, s.du), uv = dot(s.du, s.dv), vv = dot(s.dv, s.dv);
    const double tu = gu / ahead, tv = gv / ahead, du = dot(d, s.du), dv = dot(d, s.dv);
    second[0] = dot(m, s.duu) - 2 * tu * du;
    second[1] = dot(m, s.duv) - tu * dv - tv * du;
    second[2] = dot(m, s.dvv) - 2 * tv * dv;
  }

  // Downhill by Newton where the Hessian is positive definite, else by its first order part.
  GABARIT_HD Parameters step() const {
    const double a = uu + second[0], b = uv + second[1], c = vv + second[2];
    if (a > 1e-9 * uu && c > 1e-9 * vv && a * c - b * b > 1e-9 * uu * vv) return solved(a, b, c);
    const double tiny = 1e-12 * (uu + vv);
    return solved(uu + tiny, uv, vv + tiny);
  }
  GABARIT_HD double residual() const {
    const double along_u = uu > 0 ? std::fabs(gu) / std::sqrt(uu) : 0;
    const double along_v = vv > 0 ? std::fabs(gv) / std::sqrt(vv) : 0;
    return along_u > along_v ? along_u : along_v;
  }

 private:
  GABARIT_HD Parameters solved(double a, double b, double c) const {
    const double area = a * c - b * b;
    if (!(area > 0)) return {a > 0 ? -gu / a : 0, c > 0 ? -gv / c : 0};
    return {-(c * gu - b * gv) / area, -(a * gv - b * gu) / area};
  }

  double second[3] = {0, 0, 0};
};

// Where the parameters may go: over the ends of the face's range by its width, for the foot may lie outside
// the trimming curves and come back; never off the surface itself.
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

// From the parameters on, downhill on the whole surface of the face; the trimming curves are not looked at.
GABARIT_HD inline BallFoot foot_on_surface(const BrepView& brep, const Face& face, const Vec3d& o,
                                           const Vec3d& d, Parameters at) {
  constexpr int most_steps = 40, most_halvings = 30;
  const Surface& surface = brep.surfaces[face.surface];
  SurfacePoint s = face_point(brep, face, at);
  BallFoot foot;
  foot.at = at, foot.contact = s.p, foot.radius = ball_radius(s.p - o, d);
  for (; foot.steps < most_steps && foot.radius < std::numeric_limits<double>::infinity(); ++foot.steps) {
    const BallSlope slope(s, o, d);
    foot.residual = slope.residual();
    if (foot.residual <= 1e-13 * (foot.radius + length(s.p - o))) break;
    const Parameters step = slope.step();
    double part = 1;
    bool down = false;
    for (int i = 0; i < most_halvings && !down; ++i, part /= 2) {
      const Parameters next =
          kept_on_surface(surface, face, {foot.at.u + part * step.u, foot.at.v + part * step.v});
      const SurfacePoint there = face_point(brep, face, next);
      const double radius = ball_radius(there.p - o, d);
      down = radius < foot.radius;
      if (down) foot.at = next, foot.radius = radius, foot.contact = there.p, s = there;
    }
    if (!down) break;
  }
  return foot;
}

// The same along the curve of an edge.
GABARIT_HD inline BallFoot foot_on_edge(const BrepView& brep, const Edge& edge, const Vec3d& o,
                                        const Vec3d& d, double t) {
  constexpr int most_steps = 40, most_halvings = 30;
  const Curve& curve = brep.curves[edge.curve];
  CurvePoint c = curve_point(brep, curve, t);
  BallFoot foot;
  foot.at = {t, 0}, foot.contact = c.p, foot.radius = ball_radius(c.p - o, d);
  for (; foot.steps < most_steps && foot.radius < std::numeric_limits<double>::infinity(); ++foot.steps) {
    const Vec3d q = c.p - o, m = q - foot.radius * d;
    const double slope = dot(m, c.d), first = dot(c.d, c.d), ahead = dot(d, q);
    foot.residual = first > 0 ? std::fabs(slope) / std::sqrt(first) : 0;
    if (foot.residual <= 1e-13 * (foot.radius + length(q))) break;
    const double second = first + dot(m, c.dd) - 2 * (slope / ahead) * dot(d, c.d);
    const double step = -slope / (second > 1e-9 * first ? second : first);
    double part = 1;
    bool down = false;
    for (int i = 0; i < most_halvings && !down; ++i, part /= 2) {
      double next = foot.at.u + part * step;
      next = next < edge.first ? edge.first : next > edge.last ? edge.last : next;
      const CurvePoint there = curve_point(brep, curve, next);
      const double radius = ball_radius(there.p - o, d);
      down = radius < foot.radius;
      if (down) foot.at.u = next, foot.radius = radius, foot.contact = there.p, c = there;
    }
    if (!down) break;
  }
  return foot;
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
