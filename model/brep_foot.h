// Where the ball that is tangent at a point first meets a face or an edge of a Brep: the smallest
// t = |P - O|² / (2 d·(P - O)) over P, by Newton's method with second derivatives, after Lemasson et al.,
// Accurate thickness computation of a B-Rep model on the GPU (2014).
#pragma once

#include <limits>

#include "model/brep_curvature.h"
#include "model/brep_trim.h"

namespace gabarit {

// All balls that touch the surface at `point` with their centre along `direction` (unit) from it.
struct Pencil {
  Vec3d point, direction;
};

// The ball of a pencil through one point. `ahead` is d·q: negative or 0 when no ball of the pencil gets
// there.
struct PencilBall {
  double radius = std::numeric_limits<double>::infinity();
  double ahead = 0;
  Vec3d arm;  // from the centre to the point; as long as the radius
};

GABARIT_HD inline PencilBall ball_of(const Pencil& pencil, const Vec3d& p) {
  const Vec3d q = p - pencil.point;
  const double ahead = dot(pencil.direction, q);
  if (!(ahead > 0)) return {std::numeric_limits<double>::infinity(), ahead, {}};
  const double t = squared_length(q) / (2 * ahead);
  return {t, ahead, q - t * pencil.direction};
}

struct FaceFoot {
  Parameters at;
  SurfacePoint surface;
  double radius = std::numeric_limits<double>::infinity();
  double residual = std::numeric_limits<double>::infinity();  // mm: of the arm across the surface's normal
  int iterations = 0;
  bool found = false;   // a stationary point inside the face's range
  bool above = false;   // not followed to its end: it stays above the reach, or leads where a foot is known
  bool at_end = false;  // as far as the face's range goes: smaller balls are outside of it
};

// A symmetric form in the plane of the parameters.
struct Form2 {
  double uu, uv, vv;
  GABARIT_HD double determinant() const { return uu * vv - uv * uv; }
  // x with form·x = g; the form is positive definite.
  GABARIT_HD Parameters solve(double gu, double gv) const {
    const double d = determinant();
    return {(vv * gu - uv * gv) / d, (uu * gv - uv * gu) / d};
  }
  GABARIT_HD double value(double u, double v) const { return uu * u * u + 2 * uv * u * v + vv * v * v; }
};

GABARIT_HD inline Form2 first_form(const SurfacePoint& s) {
  return {dot(s.du, s.du), dot(s.du, s.dv), dot(s.dv, s.dv)};
}

// The outward normal, on spheres also where their parameters have poles.
GABARIT_HD inline Vec3d outward_normal_at(const BrepView& brep, const Face& face, const SurfacePoint& s) {
  const Surface& surface = brep.surfaces[face.surface];
  if (surface.kind != SurfaceKind::sphere) return outward_normal(s, face.sign);
  const Axes& axes = surface.axes;
  const double hand = dot(cross(axes.x, axes.y), axes.z) < 0 ? -face.sign : face.sign;
  return normalized(s.p - axes.origin) * hand;
}

// A foot that is known.
GABARIT_HD inline FaceFoot known_foot(const BrepView& brep, const Face& face, const Pencil& pencil,
                                      Parameters at) {
  FaceFoot foot;
  foot.at = at;
  foot.surface = face_point(brep, face, at);
  const PencilBall ball = ball_of(pencil, foot.surface.p);
  foot.radius = ball.radius;
  foot.found = ball.ahead > 0;
  const Vec3d n = outward_normal_at(brep, face, foot.surface);
  foot.residual = length(ball.arm - n * dot(n, ball.arm));
  return foot;
}

// Minima that are known already; the latest ones.
struct KnownFeet {
  static constexpr int most = 8;
  struct {
    FaceId face;
    Parameters at;
  } feet[most];
  int added = 0;

  GABARIT_HD int count() const { return added < most ? added : most; }
  GABARIT_HD void add(FaceId face, Parameters at) { feet[added++ % most] = {face, at}; }
};

// Newton's method on one face from one place.
class FaceDescent {
 public:
  // Balls of `reach` or more and feet that are known are of no interest: a descent that will not get below
  // the one, or is about to end at the other, ends.
  GABARIT_HD FaceDescent(const BrepView& brep, FaceId face, const Pencil& pencil, double reach,
                         const KnownFeet& known)
      : brep_(brep), id_(face), face_(brep.faces[face]), pencil_(pencil), reach_(reach), known_(known) {
    const Surface& s = brep.surfaces[face_.surface];
    u_free_ = s.u_periodic, v_free_ = s.v_periodic;
  }

  GABARIT_SEPARATE GABARIT_HD FaceFoot run(Parameters from) {
    FaceFoot foot;
    move_to(foot, clamped(from));
    while (foot.iterations < most_iterations && step(foot)) ++foot.iterations;
    return foot;
  }

 private:
  static constexpr int most_iterations = 40;
  static constexpr int most_halvings = 40;
  static constexpr double stiffest = 0.05;

  GABARIT_HD void move_to(FaceFoot& foot, Parameters at) {
    foot.at = at;
    foot.surface = face_point(brep_, face_, at);
    ball_ = ball_of(pencil_, foot.surface.p);
    foot.radius = ball_.radius;
  }

  GABARIT_HD Parameters clamped(Parameters at) const {
    const ParameterBox& r = face_.range;
    if (!u_free_) at.u = at.u < r.u0 ? r.u0 : at.u > r.u1 ? r.u1 : at.u;
    if (!v_free_) at.v = at.v < r.v0 ? r.v0 : at.v > r.v1 ? r.v1 : at.v;
    return at;
  }

  // False when there is nowhere to go.
  GABARIT_HD bool step(FaceFoot& foot) {
    if (!(ball_.ahead > 0)) return false;
    const SurfacePoint& s = foot.surface;
    const Vec3d &w = ball_.arm, &d = pencil_.direction;
    double gu = dot(w, s.du), gv = dot(w, s.dv);
    Form2 metric = first_form(s);
    const double least = 1e-14 * (metric.uu + metric.vv);
    if (!(metric.determinant() > least * (metric.uu + metric.vv))) metric.uu += least, metric.vv += least;
    const double scale = ball_.radius + 1e-3 * length(pencil_.point);
    foot.residual = residual(metric, gu, gv);
    const double h = ball_.ahead, fu = gu / h, fv = gv / h;
    Form2 second{metric.uu + dot(w, s.duu) - 2 * fu * dot(d, s.du),
                 metric.uv + dot(w, s.duv) - fu * dot(d, s.dv) - fv * dot(d, s.du),
                 metric.vv + dot(w, s.dvv) - 2 * fv * dot(d, s.dv)};
    if (foot.residual <= 1e-13 * scale) return foot.found = true, false;
    const bool convex = second.uu > 0 && second.determinant() > 1e-8 * metric.determinant();
    if (convex && hopeless(foot, metric, second, gu, gv)) return foot.above = true, false;
    return descend(foot, convex ? second : positive(second, metric), second, metric, gu, gv);
  }

  // Downhill with Newton's speed where the form is not positive: its eigenvalues (those of the metric are 1)
  // by their size, which makes it a sum of the two forms.
  GABARIT_HD Form2 positive(const Form2& second, const Form2& metric) const {
    const double area = metric.determinant();
    const double mean =
        (second.uu * metric.vv - 2 * second.uv * metric.uv + second.vv * metric.uu) / (2 * area);
    const double squared = mean * mean - second.determinant() / area;
    const double half = std::sqrt(squared > 0 ? squared : 0.0);
    const double high = sized(mean + half), low = sized(mean - half);
    const double slope = half > 1e-12 ? (high - low) / (2 * half) : 0;
    const double rest = high - slope * (mean + half);
    return {rest * metric.uu + slope * second.uu, rest * metric.uv + slope * second.uv,
            rest * metric.vv + slope * second.vv};
  }
  // Along valleys that hardly bend `stiffness_` sets the length of a step.
  GABARIT_HD double sized(double eigenvalue) const {
    return eigenvalue > 1e-4 ? eigenvalue : eigenvalue < -stiffness_ ? -eigenvalue : stiffness_;
  }

  // Where the surface is nearly a quadratic, Newton's step tells how much smaller the ball can get.
  GABARIT_HD bool hopeless(const FaceFoot& foot, const Form2& metric, const Form2& second, double gu,
                           double gv) const {
    const Parameters go = second.solve(gu, gv);
    const double less = (gu * go.u + gv * go.v) / ball_.ahead;
    const double way = metric.value(go.u, go.v);
    const bool stays = foot.radius - less >= reach_ * (1 - 1e-10) && less < 1e-2 * foot.radius &&
                       way < 1e-2 * foot.radius * foot.radius;
    return stays || leads_to_known(foot.at, go, metric);
  }
  GABARIT_HD bool leads_to_known(Parameters from, Parameters back, const Form2& metric) const {
    for (int i = 0; i < known_.count(); ++i) {
      if (known_.feet[i].face != id_) continue;
      const Parameters& foot = known_.feet[i].at;
      const double off = metric.value(foot.u - from.u + back.u, foot.v - from.v + back.v);
      if (off <= 1e-2 * metric.value(back.u, back.v)) return true;
    }
    return false;
  }

  GABARIT_HD static double residual(const Form2& metric, double gu, double gv) {
    const Parameters x = metric.solve(gu, gv);
    const double squared = x.u * gu + x.v * gv;
    return squared > 0 ? std::sqrt(squared) : 0.0;
  }

  // A parameter at the end of its range that would leave it goes to the end and stays there.
  GABARIT_HD bool descend(FaceFoot& foot, const Form2& form, const Form2& second, const Form2& metric,
                          double gu, double gv) {
    Parameters go = shortened(form.solve(-gu, -gv));
    const bool u_ends = u_leaves(foot.at.u, go.u);
    if (u_ends) go = shortened({0, -gv / (sized(second.vv / metric.vv) * metric.vv)});
    const bool v_ends = v_leaves(foot.at.v, go.v);
    if (v_ends && !u_ends) go = shortened({-gu / (sized(second.uu / metric.uu) * metric.uu), 0});
    const bool both = v_ends && (u_ends || u_leaves(foot.at.u, go.u));
    if (both || u_ends) go.u = 0;
    if (v_ends) go.v = 0;
    const double slope = (gu * go.u + gv * go.v) / ball_.ahead;
    const bool at_end = u_ends || v_ends;
    if (at_end && !(slope < -1e-14 * foot.radius)) return foot.at_end = true, false;
    return search(foot, go, slope, at_end);
  }

  // As near to the end of the range as makes no difference.
  GABARIT_HD static bool leaves(bool open, double at, double low, double high, double by) {
    const double near = 1e-9 * (high - low);
    return !open && ((by < 0 && at - low <= near) || (by > 0 && high - at <= near));
  }
  GABARIT_HD bool u_leaves(double at, double by) const {
    return leaves(u_free_, at, face_.range.u0, face_.range.u1, by);
  }
  GABARIT_HD bool v_leaves(double at, double by) const {
    return leaves(v_free_, at, face_.range.v0, face_.range.v1, by);
  }

  // Near a pole a step may be many turns.
  GABARIT_HD Parameters shortened(Parameters go) const {
    const ParameterBox& r = face_.range;
    const double u = std::fabs(go.u) / ((r.u1 - r.u0) * (u_free_ ? 0.25 : 1.0));
    const double v = std::fabs(go.v) / ((r.v1 - r.v0) * (v_free_ ? 0.25 : 1.0));
    const double most = u > v ? u : v;
    return most > 1 ? Parameters{go.u / most, go.v / most} : go;
  }

  // Shorter and shorter until the ball is smaller.
  GABARIT_HD bool search(FaceFoot& foot, Parameters go, double slope, bool at_end) {
    const FaceFoot before = foot;
    const PencilBall ball = ball_;
    double share = 1;
    for (int i = 0; i < most_halvings; ++i, share /= 2) {
      const Parameters to = clamped({before.at.u + share * go.u, before.at.v + share * go.v});
      if (to.u == before.at.u && to.v == before.at.v) break;
      move_to(foot, to);
      if (ball_.ahead > 0 && ball_.radius <= before.radius + 1e-4 * share * slope) {
        stiffness_ *= share == 1 ? 0.125 : 8;
        stiffness_ = stiffness_ < 1e-7 ? 1e-7 : stiffness_ > stiffest ? stiffest : stiffness_;
        return true;
      }
      // Below the last digits of the radius only the residual tells.
      if (ball_.ahead > 0 && -slope < 1e-13 * before.radius) return settle(foot, before, ball, at_end);
    }
    foot = before, ball_ = ball;
    foot.found = !at_end && foot.residual <= near_enough * foot.radius;
    foot.at_end = !foot.found && (at_end || on_end(foot.at));
    return false;
  }

  GABARIT_HD bool on_end(Parameters at) const {
    const ParameterBox& r = face_.range;
    return (!u_free_ && (at.u <= r.u0 || at.u >= r.u1)) || (!v_free_ && (at.v <= r.v0 || at.v >= r.v1));
  }

  GABARIT_HD bool settle(FaceFoot& foot, const FaceFoot& before, const PencilBall& ball, bool at_end) {
    const Form2 metric = first_form(foot.surface);
    const double now = residual(metric, dot(ball_.arm, foot.surface.du), dot(ball_.arm, foot.surface.dv));
    if (now < before.residual)
      foot.residual = now;
    else
      foot = before, ball_ = ball;
    foot.found = !at_end && foot.residual <= near_enough * foot.radius;
    foot.at_end = at_end;
    return false;
  }

  static constexpr double near_enough = 3e-6;  // of the radius; the radius errs by the square

  const BrepView& brep_;
  FaceId id_;
  const Face& face_;
  const Pencil& pencil_;
  double reach_;
  const KnownFeet& known_;
  double stiffness_ = stiffest;
  bool u_free_ = false, v_free_ = false;
  PencilBall ball_;
};

}  // namespace gabarit
