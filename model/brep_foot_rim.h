// The smallest ball of a pencil on the rim of a face: where the outward normal turns away from the pencil by
// just the angle from which on contacts count. On a smooth wall that bends away the nearest contact that
// counts lies there, and the ball cuts through the wall beyond it.
#pragma once

#include "model/brep_foot.h"

namespace gabarit {

// The derivatives of the outward unit normal.
struct NormalTurn {
  Vec3d n, du, dv;
};

GABARIT_HD inline NormalTurn normal_turn(const SurfacePoint& s, double sign) {
  const Vec3d raw = cross(s.du, s.dv);
  const Vec3d raw_u = cross(s.duu, s.dv) + cross(s.du, s.duv);
  const Vec3d raw_v = cross(s.duv, s.dv) + cross(s.du, s.dvv);
  const double area = length(raw);
  const Vec3d n = outward_normal(s, sign);
  if (n == Vec3d{}) return {};
  const Vec3d u = raw_u * (sign / area), v = raw_v * (sign / area);
  return {n, u - n * dot(n, u), v - n * dot(n, v)};
}

// outward normal · axis is `least` on the rim.
class RimDescent {
 public:
  GABARIT_HD RimDescent(const BrepView& brep, FaceId face, const Pencil& pencil, const Vec3d& axis,
                        double least)
      : brep_(brep),
        face_(brep.faces[face]),
        pencil_(pencil),
        axis_(axis),
        angle_(std::acos(least < -1 ? -1.0 : least)) {}

  GABARIT_HD FaceFoot run(Parameters from) const {
    FaceFoot foot;
    if (!reach_rim(from, foot)) return foot;
    double slope = slope_along(foot), second = 1;
    double length_scale = foot.radius;
    for (foot.iterations = 0; foot.iterations < most_iterations; ++foot.iterations) {
      foot.residual = std::fabs(slope);
      if (foot.residual <= 1e-11) break;
      const double wanted = -slope * length_scale / second;
      const double most = 0.5 * foot.radius;
      double go = wanted > most ? most : wanted < -most ? -most : wanted;
      FaceFoot next;
      bool lower = false;
      for (int i = 0; i < most_halvings && !lower; ++i, go /= 2)
        lower = reach_rim(along(foot, go), next) && next.radius < foot.radius;
      foot.at_end = !lower && next.at_end;
      if (!lower) break;
      const double next_slope = slope_along(next);
      const double bend = (next_slope - slope) / (2 * go) * length_scale;
      // Where the rim does not bend away, longer and longer steps.
      second = bend > 1e-4 ? bend : second / 4;
      next.iterations = foot.iterations;
      foot = next, slope = next_slope;
    }
    foot.residual = std::fabs(slope);
    foot.found = foot.residual <= 1e-4;
    if (on_sphere()) foot.at = between_poles(foot.at);
    return foot;
  }

 private:
  static constexpr int most_iterations = 30;
  static constexpr int most_halvings = 16;

  struct Rim {
    double off;        // facing - least
    double fu, fv;     // its derivatives
    Parameters up;     // direction of steepest rise
    double steepness;  // squared, 1/mm²
  };

  GABARIT_HD bool on_sphere() const { return brep_.surfaces[face_.surface].kind == SurfaceKind::sphere; }

  // Over the pole of a sphere du turns round.
  GABARIT_HD Rim rim_at(Parameters at, const SurfacePoint& s) const {
    const bool beyond = on_sphere() && std::cos(at.v) < 0;
    const NormalTurn turn = normal_turn(s, beyond ? -face_.sign : face_.sign);
    // The angle from the axis: its gradient stays finite where the normal is along it.
    const double facing = dot(turn.n, axis_), across = length(cross(turn.n, axis_));
    const double sine = across > 1e-9 ? across : 1e-9;
    const double fu = -dot(turn.du, axis_) / sine, fv = -dot(turn.dv, axis_) / sine;
    const Form2 metric = first_form(s);
    if (turn.n == Vec3d{} || !(metric.determinant() > 0)) return {0, 0, 0, {}, 0};
    const Parameters up = metric.solve(fu, fv);
    return {std::atan2(across, facing) - angle_, fu, fv, up, fu * up.u + fv * up.v};
  }

  // Up or down the steepest way until the normal is right.
  GABARIT_HD bool reach_rim(Parameters at, FaceFoot& foot) const {
    for (int i = 0; i < 20; ++i) {
      const SurfacePoint s = face_point(brep_, face_, at);
      const Rim rim = rim_at(at, s);
      if (!(rim.steepness > 1e-12)) return foot.at_end = true, false;  // it does not turn: no rim
      if (std::fabs(rim.off) < 1e-12) {
        const PencilBall ball = ball_of(pencil_, s.p);
        foot.at = at, foot.surface = s, foot.radius = ball.radius;
        return ball.ahead > 0;
      }
      at.u -= rim.off / rim.steepness * rim.up.u, at.v -= rim.off / rim.steepness * rim.up.v;
      if (!inside_domain(at)) return foot.at_end = true, false;
    }
    return false;
  }

  GABARIT_HD bool inside_domain(Parameters at) const {
    if (on_sphere()) return true;
    const Surface& s = brep_.surfaces[face_.surface];
    const ParameterBox& r = face_.range;
    const double u = 0.1 * (r.u1 - r.u0), v = 0.1 * (r.v1 - r.v0);
    return (s.u_periodic || (at.u >= r.u0 - u && at.u <= r.u1 + u)) &&
           (s.v_periodic || (at.v >= r.v0 - v && at.v <= r.v1 + v));
  }

  // One millimetre along the rim, in parameters.
  GABARIT_HD Parameters tangent(const FaceFoot& foot) const {
    const Rim rim = rim_at(foot.at, foot.surface);
    const Parameters raw{-rim.fv, rim.fu};
    const double speed = std::sqrt(first_form(foot.surface).value(raw.u, raw.v));
    return speed > 0 ? Parameters{raw.u / speed, raw.v / speed} : Parameters{};
  }
  GABARIT_HD Parameters along(const FaceFoot& foot, double by) const {
    const Parameters t = tangent(foot);
    return {foot.at.u + by * t.u, foot.at.v + by * t.v};
  }
  // Of the radius, mm a mm.
  GABARIT_HD double slope_along(const FaceFoot& foot) const {
    const Parameters t = tangent(foot);
    const PencilBall ball = ball_of(pencil_, foot.surface.p);
    return dot(ball.arm, foot.surface.du * t.u + foot.surface.dv * t.v) / ball.ahead;
  }

  const BrepView& brep_;
  const Face& face_;
  const Pencil& pencil_;
  Vec3d axis_;
  double angle_;
};

}  // namespace gabarit
