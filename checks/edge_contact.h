// Where a ball of a pencil first meets a piece of an edge, and whether that stops it.
#pragma once

#include "checks/exact_surface.h"
#include "model/brep_foot_edge.h"

namespace gabarit {

class EdgeContact {
 public:
  // Outward normals, seen from the ball's side, count when their cosine with the direction is at least this.
  GABARIT_HD EdgeContact(const ExactView& view, const Pencil& pencil, double least_facing,
                         std::uint32_t number)
      : view_(view),
        pencil_(pencil),
        axis_(pencil.direction * view.side),
        least_facing_(least_facing),
        piece_(view.pieces[number]),
        curve_(curve_of(piece_)) {
    const bool drawn = piece_.edge != no_number;
    first_ = drawn ? piece_.first : 0.0, last_ = drawn ? piece_.last : 1.0;
  }

  GABARIT_HD CurveFoot nearest(double from) const {
    return CurveDescent(view_.brep, curve_, pencil_).run(first_, last_, from);
  }

  // Whether a face beside it can count anywhere along it.
  GABARIT_HD bool can_face() const { return can_face(piece_.beside[0]) || can_face(piece_.beside[1]); }
  // Whether it can be reflex.
  GABARIT_HD bool can_be_hollow() const {
    return (view_.side > 0 ? piece_.least_turn : -piece_.greatest_turn) < 0;
  }

  // Whether a face beside it counts there, or the edge itself as a reflex one.
  GABARIT_HD bool counts(const CurveFoot& foot) const {
    Vec3d normal[2];
    for (std::size_t k = 0; k < 2; ++k) {
      if (!can_face(piece_.beside[k])) continue;
      normal[k] = normal_beside(piece_.beside[k], foot.curve.p, foot.t);
      if (dot(normal[k], axis_) >= least_facing_ - slack) return true;
    }
    return foot.inside && can_be_hollow() && reflex(foot, normal);
  }

  // Between the foot, where the face on one side does not count, and an end of the piece, where it does: the
  // place where it begins to. False when it does not count at that end either, or only at balls of `reach`
  // and more.
  GABARIT_HD bool end_of_side(std::size_t k, bool at_first, double reach, CurveFoot& foot) const {
    const EdgePiece::Beside& side = piece_.beside[k];
    const double end = at_first ? first_ : last_;
    if (!can_face(side) || end == foot.t) return false;
    double no = foot.t, yes = end, off_no = facing(side, no), off_yes = facing(side, yes);
    if (!(off_yes >= 0)) return false;
    // By the straight line between the two, and by half wherever that is slow.
    for (int i = 0; i < 60 && ball_of(pencil_, point(no)).radius < reach; ++i) {
      const double share = i % 3 == 2 ? 0.5 : off_no / (off_no - off_yes);
      const double middle = no + (yes - no) * (share > 0.01 ? (share < 0.99 ? share : 0.99) : 0.01);
      if (middle == no || middle == yes) break;
      const double off = facing(side, middle);
      if (off >= 0)
        yes = middle, off_yes = off;
      else
        no = middle, off_no = off;
      if (off >= 0 && off < 1e-12) break;
    }
    foot.t = yes;
    foot.curve = curve_point(view_.brep, curve_, yes);
    foot.radius = ball_of(pencil_, foot.curve.p).radius;
    foot.residual = 0;
    return foot.radius < reach;
  }

 private:
  static constexpr double slack = 1e-6;  // as for meshes

  GABARIT_HD Curve curve_of(const EdgePiece& piece) const {
    if (piece.edge != no_number) return view_.brep.curves[view_.brep.edges[piece.edge].curve];
    Curve line;
    line.axes.origin = piece.a;
    line.axes.x = piece.b - piece.a;
    return line;
  }

  // The outward normal of the face at a point of its edge.
  GABARIT_SEPARATE GABARIT_HD Vec3d normal_beside(const EdgePiece::Beside& side, const Vec3d& p,
                                                  double t) const {
    const Face& face = view_.brep.faces[side.face];
    if (view_.brep.surfaces[face.surface].kind == SurfaceKind::plane) return side.mean;
    const double share = (t - first_) / (last_ - first_);
    Parameters at{side.at[0].u + share * (side.at[1].u - side.at[0].u),
                  side.at[0].v + share * (side.at[1].v - side.at[0].v)};
    SurfacePoint s = face_point(view_.brep, face, at);
    for (int i = 0; i < 4; ++i) {
      const Form2 metric = first_form(s);
      if (!(metric.determinant() > 1e-14 * metric.uu * metric.vv)) break;
      const Vec3d off = p - s.p;
      const Parameters go = metric.solve(dot(off, s.du), dot(off, s.dv));
      at.u += go.u, at.v += go.v;
      s = face_point(view_.brep, face, at);
      if (metric.value(go.u, go.v) < 1e-12) break;  // the next step would be far shorter
    }
    const Vec3d n = outward_normal_at(view_.brep, face, s);
    return n == Vec3d{} ? side.mean : n;
  }

  // Whether the edge is hollow as the ball sees it and both faces leave the ball. Normals that are known
  // already are given.
  GABARIT_HD bool reflex(const CurveFoot& foot, Vec3d (&n)[2]) const {
    const Vec3d w = ball_of(pencil_, foot.curve.p).arm / foot.radius;
    if (dot(w, pencil_.direction) < least_facing_ - slack) return false;
    for (std::size_t k = 0; k < 2; ++k) {
      const EdgePiece::Beside& side = piece_.beside[k];
      if (side.face != no_number && n[k] == Vec3d{}) n[k] = normal_beside(side, foot.curve.p, foot.t);
    }
    const Vec3d along = normalized(foot.curve.d * (last_ > first_ ? 1.0 : -1.0));
    if (piece_.beside[1].face == no_number) return dot(cross(n[0], along), w) >= -1e-6;
    const bool hollow = view_.side * dot(cross(n[0], n[1]), along) < -1e-9;
    return hollow && dot(cross(n[0], along), w) >= -1e-6 && dot(cross(along, n[1]), w) >= -1e-6;
  }

  GABARIT_HD bool can_face(const EdgePiece::Beside& side) const {
    if (side.face == no_number) return false;
    const double facing = dot(side.mean, axis_);
    const double angle = arc_cosine(facing > 1 ? 1.0 : facing < -1 ? -1.0 : facing);
    return angle <= side.spread || cosine(angle - side.spread) >= least_facing_ - slack;
  }

  GABARIT_HD Vec3d point(double t) const { return curve_point(view_.brep, curve_, t).p; }
  // Not negative where the face beside it counts.
  GABARIT_HD double facing(const EdgePiece::Beside& side, double t) const {
    return dot(normal_beside(side, point(t), t), axis_) - least_facing_;
  }

  const ExactView& view_;
  const Pencil& pencil_;
  Vec3d axis_;
  double least_facing_;
  const EdgePiece& piece_;
  Curve curve_;
  double first_ = 0, last_ = 1;
};

}  // namespace gabarit
