// The line on a face along which its normal turns away from a direction by just so much, and the smallest
// tangent ball that reaches it.
#pragma once

#include "model/brep_tangent_ball.h"

namespace gabarit {

struct SeparationLine {
  const BrepView& brep;
  const Face& face;
  double sign;    // of the side, see ExactBallOptions
  Vec3d o, d;     // the ball's point and direction
  double facing;  // normal · d on the line

  // From parameters close to the line: down along it, by secants of the slope.
  GABARIT_HD BallFoot least_from(Parameters start) const {
    Place here = place(start);
    double step = here.length > 0 ? -here.slope / here.first : 0;
    BallFoot foot;
    for (; foot.steps < 60 && here.length > 0 && here.residual() > 1e-12 * here.radius; ++foot.steps) {
      Place there;
      bool down = false;
      for (int i = 0; i < 30 && !down; ++i) {
        there = place({here.at.u + step * here.along.u, here.at.v + step * here.along.v});
        down = there.length > 0 && there.radius < here.radius;
        if (!down) step /= 2;
      }
      if (!down) break;
      const double bend = (there.slope_towards(here) - here.slope) / step;
      here = there;
      step = bend > 1e-3 * here.first ? -here.slope / bend : -here.slope / here.first;
    }
    foot.at = here.at, foot.contact = here.point, foot.radius = here.radius, foot.residual = here.residual();
    return foot;
  }

 private:
  struct Place {
    Parameters at, along;  // along the line, a unit vector of the parameters
    Vec3d point;
    double radius = std::numeric_limits<double>::infinity();
    double slope = 0;   // of (radius · ahead) along it
    double first = 0;   // |dS|² along it
    double length = 0;  // 0: the line has no direction here
    GABARIT_HD double residual() const { return std::fabs(slope) / std::sqrt(first); }
    // The slope in the direction in which `before` runs.
    GABARIT_HD double slope_towards(const Place& before) const {
      return along.u * before.along.u + along.v * before.along.v < 0 ? -slope : slope;
    }
  };

  // The derivatives of normal · d by u and v, from the shape operator.
  GABARIT_HD Parameters turn_of(const SurfacePoint& s, const Vec3d& n) const {
    const double e = dot(s.du, s.du), f = dot(s.du, s.dv), g = dot(s.dv, s.dv), area = e * g - f * f;
    const double l = dot(s.duu, n), m = dot(s.duv, n), k = dot(s.dvv, n);
    const double du = dot(s.du, d), dv = dot(s.dv, d);
    const double a = (g * du - f * dv) / area, b = (e * dv - f * du) / area;  // d = a·S_u + b·S_v + …
    return {-(l * a + m * b), -(m * a + k * b)};
  }

  // The nearest place of the line: Newton along the steepest way.
  GABARIT_HD Place place(Parameters p) const {
    const Surface& surface = brep.surfaces[face.surface];
    Place found;
    for (int i = 0; i < 12; ++i) {
      const SurfacePoint s = face_point(brep, face, p);
      const Vec3d n = outward_normal(s, sign * face.sign);
      if (n == Vec3d{}) return found;
      const Parameters turn = turn_of(s, n);
      // Steepest in the metric of the surface, roughly: each parameter by its own scale.
      const double su = dot(s.du, s.du), sv = dot(s.dv, s.dv);
      const double steep = turn.u * turn.u / su + turn.v * turn.v / sv;
      const double off = dot(n, d) - facing;
      if (!(steep > 0)) return found;
      found = at_place(s, p, turn);
      if (std::fabs(off) < 1e-14) return found;
      p = kept_on_surface(surface, face, {p.u - off * turn.u / su / steep, p.v - off * turn.v / sv / steep});
    }
    return found;
  }

  GABARIT_HD Place at_place(const SurfacePoint& s, Parameters p, Parameters turn) const {
    Place place;
    place.at = p, place.point = s.p;
    place.radius = ball_radius(s.p - o, d);
    place.length = std::sqrt(turn.u * turn.u + turn.v * turn.v);
    place.along = {-turn.v / place.length, turn.u / place.length};
    const Vec3d way = place.along.u * s.du + place.along.v * s.dv;
    place.slope = dot(s.p - o - place.radius * d, way);
    place.first = squared_length(way);
    return place;
  }
};

}  // namespace gabarit
