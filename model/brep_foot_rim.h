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

struct RimFoot : FaceFoot {
  Vec3d least;      // where the radius is least along the rim, nearly
  double bend = 0;  // 1/mm: by how much the slope of the radius changes along the rim; 0: not known
};

// Minima on rims that are known already, at least nearly; the latest ones.
struct KnownRimFeet {
  static constexpr int most = 8;
  struct {
    FaceId face;
    Vec3d point;
    double bend;
  } feet[most];
  int added = 0;

  GABARIT_HD int count() const { return added < most ? added : most; }
  GABARIT_HD void add(FaceId face, const RimFoot& foot) {
    if (foot.bend > 0) feet[added++ % most] = {face, foot.least, foot.bend};
  }
};

// outward normal · axis is `least` on the rim.
class RimDescent {
 public:
  // Balls of `reach` or more and feet that are known are of no interest.
  GABARIT_HD RimDescent(const BrepView& brep, FaceId face, const Pencil& pencil, const Vec3d& axis,
                        double least, double reach, const KnownRimFeet& known)
      : brep_(brep),
        id_(face),
        face_(brep.faces[face]),
        pencil_(pencil),
        axis_(axis),
        angle_(arc_cosine(least < -1 ? -1.0 : least)),
        reach_(reach),
        known_(known) {}

  // By secants of the slope along the rim; where it does not bend away, by longer and longer steps.
  GABARIT_SEPARATE GABARIT_HD RimFoot run(Parameters from) const {
    Place here;
    RimFoot& foot = here.foot;
    if (!reach_rim(from, here)) return foot;
    if (leads_to_known(here)) return foot.above = true, foot;  // with no bend of its own
    const double scale = foot.radius;
    double second = 1;
    for (; foot.iterations < most_iterations && std::fabs(here.slope) > flat; ++foot.iterations) {
      const double wanted = -here.slope * scale / second, most = 0.5 * foot.radius;
      double go = wanted > most ? most : wanted < -most ? -most : wanted;
      Place next;
      bool lower = false;
      for (int i = 0; i < most_halvings && !lower; ++i, go /= 2)
        lower = reach_rim(beside(here, go), next) && next.foot.radius < foot.radius;
      foot.at_end = !lower && next.foot.at_end;
      if (!lower) break;
      // The rim may run the other way there.
      if (dot(next.along, here.along) < 0) next.slope = -next.slope, next.along = -next.along, next.turn();
      const double bend = (next.slope - here.slope) / (2 * go) * scale;
      second = bend > 1e-4 ? bend : second / 4;
      next.foot.iterations = foot.iterations;
      next.foot.bend = bend > 1e-4 ? bend / scale : 0;
      if (bend > 1e-4) next.foot.least = next.foot.surface.p - next.along * (next.slope * scale / bend);
      here = next;
      if (bend > 1e-4 && hopeless(here, scale / bend)) return foot.above = true, foot;
    }
    foot.least = foot.surface.p;
    foot.residual = std::fabs(here.slope);
    foot.found = foot.residual <= 1e-4;
    return foot;
  }

 private:
  static constexpr int most_iterations = 30;
  static constexpr int most_halvings = 16;
  static constexpr double flat = 1e-9;  // of the slope, mm a mm; the radius errs by the square

  struct Place {
    RimFoot foot;
    Parameters step;   // one millimetre along the rim
    Vec3d along;       // the same in space
    double slope = 0;  // of the radius, mm a mm
    GABARIT_HD void turn() { step = {-step.u, -step.v}; }
  };

  // Close to a minimum the slope and its change tell how much smaller the ball can get.
  GABARIT_HD bool hopeless(const Place& here, double bend_radius) const {
    const double less = 0.5 * here.slope * here.slope * bend_radius;
    return here.foot.radius - less >= reach_ * (1 - 1e-10) && less < 1e-2 * here.foot.radius;
  }

  GABARIT_HD bool leads_to_known(const Place& here) const {
    for (int i = 0; i < known_.count(); ++i) {
      if (known_.feet[i].face != id_) continue;
      const Vec3d way = known_.feet[i].point - here.foot.surface.p;
      const double along = dot(way, here.along), expected = -known_.feet[i].bend * along;
      if (std::fabs(along) > 0.95 * length(way) &&
          std::fabs(expected - here.slope) < 0.1 * std::fabs(here.slope))
        return true;
    }
    return false;
  }

  // Up or down the steepest way until the normal is right.
  GABARIT_HD bool reach_rim(Parameters at, Place& place) const {
    place.foot.at_end = false;
    for (int i = 0; i < 20; ++i) {
      const SurfacePoint s = face_point(brep_, face_, at);
      const NormalTurn turn = normal_turn(s, face_.sign);
      const Form2 metric = first_form(s);
      // The angle from the axis: its gradient stays finite where the normal is along it.
      const double facing = dot(turn.n, axis_), across = length(cross(turn.n, axis_));
      const double sine = across > 1e-9 ? across : 1e-9;
      const double fu = -dot(turn.du, axis_) / sine, fv = -dot(turn.dv, axis_) / sine;
      if (turn.n == Vec3d{} || !(metric.determinant() > 0)) return place.foot.at_end = true, false;
      const Parameters up = metric.solve(fu, fv);
      const double steepness = fu * up.u + fv * up.v;                    // squared, 1/mm²
      if (!(steepness > 1e-12)) return place.foot.at_end = true, false;  // it does not turn: no rim
      const double off = angle_of(across, facing) - angle_;
      if (std::fabs(off) < 1e-11) return settle(at, s, metric, {-fv, fu}, place);
      at.u -= off / steepness * up.u, at.v -= off / steepness * up.v;
      if (!inside_domain(at)) return place.foot.at_end = true, false;
    }
    return false;
  }

  GABARIT_HD bool settle(Parameters at, const SurfacePoint& s, const Form2& metric, Parameters level,
                         Place& place) const {
    const PencilBall ball = ball_of(pencil_, s.p);
    place.foot.at = at, place.foot.surface = s, place.foot.radius = ball.radius;
    const double speed = std::sqrt(metric.value(level.u, level.v));
    place.step = {level.u / speed, level.v / speed};
    place.along = s.du * place.step.u + s.dv * place.step.v;
    place.slope = dot(ball.arm, place.along) / ball.ahead;
    return ball.ahead > 0 && speed > 0;
  }

  GABARIT_HD bool inside_domain(Parameters at) const {
    const Surface& s = brep_.surfaces[face_.surface];
    const ParameterBox& r = face_.range;
    const double u = 0.1 * (r.u1 - r.u0), v = 0.1 * (r.v1 - r.v0);
    return (s.u_periodic || (at.u >= r.u0 - u && at.u <= r.u1 + u)) &&
           (s.v_periodic || (at.v >= r.v0 - v && at.v <= r.v1 + v));
  }

  GABARIT_HD static Parameters beside(const Place& place, double by) {
    return {place.foot.at.u + by * place.step.u, place.foot.at.v + by * place.step.v};
  }

  const BrepView& brep_;
  FaceId id_;
  const Face& face_;
  const Pencil& pencil_;
  Vec3d axis_;
  double angle_, reach_;
  const KnownRimFeet& known_;
};

}  // namespace gabarit
