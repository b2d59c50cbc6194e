// The search for the largest ball on one side of the exact surfaces that touches them at a point. One
// best-first walk of the tree; whatever could be nearer than the best contact so far, as the facets and their
// distance from the surface tell, is looked at on the surface itself.
#pragma once

#include "checks/edge_contact.h"
#include "checks/exact_ball.h"
#include "gpu/sphere_culling.h"
#include "gpu/tangent_ball.h"
#include "model/brep_foot_closed.h"
#include "model/brep_foot_rim.h"
#include "model/brep_pole.h"

namespace gabarit {

class ExactBallSearch {
 public:
  GABARIT_HD ExactBallSearch(const ExactView& view, const ExactBallOptions& options,
                             const ExactBallQuery& query)
      : view_(view),
        options_(options),
        pencil_{query.point, query.direction},
        axis_(query.direction * view.side),
        least_facing_(-options.cos_separation),
        angle_(arc_cosine(least_facing_ < -1 ? -1.0 : least_facing_)),
        culling_(view.tree, loosened(options, angle_ + view.normal_error), query.point, query.direction) {
    const double loose = angle_ + view.normal_error + 1e-6;
    loose_facing_ = loose < pi ? cosine(loose) : -1;
    set_reach(options.greatest_radius);
    if (least_facing_ <= -1 + 1e-12 && query.own_curvature > 0) curve_in(query);
  }

  GABARIT_HD float limit() const { return culling_.probe(); }
  template <class Boxes>
  GABARIT_HD void within(const Boxes& boxes, EightFloats& lower) const {
    culling_.within(boxes, lower);
  }
  GABARIT_HD void visit(const Primitive& p) {
    if (p.id < view_.facets.size)
      visit_facet(p);
    else if (p.corner[0] == p.corner[1])
      visit_corner(view_.corners[p.corner[2] - view_.pieces.size]);
    else
      visit_piece(p);
  }

  // Starts from what was nearest to a neighbouring point.
  GABARIT_HD void begin_at(const ExactBall& contact) {
    const bool on_face = contact.kind == BallContact::face || contact.kind == BallContact::separation;
    const Known known = on_face ? solve(contact.face) : Known::all;
    if (on_face && known == Known::all) return;
    if (contact.kind == BallContact::face && known == Known::nothing)
      try_face(contact.face, contact.at, infinite);
    else if (contact.kind == BallContact::separation)
      try_rim(contact.face, contact.at, infinite);
    else if (contact.piece != no_number)
      try_piece(contact.piece, contact.t, false);
  }

  GABARIT_HD ExactBall result() const {
    ExactBall ball = best_;
    ball.verified = !(unexplained_ < reach_);
    return ball;
  }

 private:
  static constexpr double pi = 3.14159265358979323846;
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr double facing_slack = 1e-6;  // as for meshes
  static constexpr int most_starts = 2000;

  // `angle`: by which the normals of facets may turn away from the direction.
  GABARIT_HD static SphereOptions loosened(const ExactBallOptions& options, double angle) {
    return {angle + 1e-6 < pi ? -cosine(angle + 1e-6) : 1.0, options.greatest_radius, options.contact_floor};
  }

  GABARIT_HD void curve_in(const ExactBallQuery& query) {
    ExactBall own;
    own.radius = 1 / query.own_curvature;
    own.contact = query.point;
    own.kind = BallContact::curvature;
    record(own);
  }

  GABARIT_HD void set_reach(double reach) {
    reach_ = reach;
    culling_.set_radius(reach);
  }

  GABARIT_HD void record(ExactBall contact) {
    if (!(contact.radius < reach_)) return;
    contact.steps = best_.steps, contact.starts = best_.starts;
    best_ = contact;
    set_reach(contact.radius);
  }

  // Something that Newton's method did not settle may be as near as this.
  GABARIT_HD void leave_unexplained(double bound) {
    if (bound < unexplained_) unexplained_ = bound;
  }

  GABARIT_HD bool far_enough(const Vec3d& p, double radius) const {
    const double least = options_.contact_floor > 1e-3 * radius ? options_.contact_floor : 1e-3 * radius;
    return squared_length(p - pencil_.point) > least * least;
  }

  GABARIT_HD void visit_facet(const Primitive& p) {
    const Vec3d& d = pencil_.direction;
    if (p.is_facet() && dot(p.normal, d) < loose_facing_) return;
    const FacetOrigin& origin = view_.facets[p.id];
    Known known = known_of(origin.face);
    if (known == Known::all || !can_count(p)) return;
    // Contacts within e of a facet are those of a ball that is larger by e and starts e further back.
    const double e = static_cast<double>(view_.facet_sags[p.id]) + 1e-12 * view_.size;
    const Vec3d back = e * d;
    const Vec3d a = corner(p.id, 0) - pencil_.point, b = corner(p.id, 1) - pencil_.point,
                c = corner(p.id, 2) - pencil_.point;
    const TangentBall ball = ball_through_triangle(d, a + back, b + back, c + back, reach_ + e);
    const double bound = ball.radius - e;
    if (!(bound < reach_)) return;
    if (known == Known::nothing) known = solve(origin.face);
    if (known == Known::all || (known == Known::feet && !on_rim(p))) return;
    Parameters from = parameters_of(origin, ball.contact - back, a, b, c);
    if (!get_ahead(origin, from)) return;
    const bool crossed = known == Known::nothing && try_face(origin.face, from, bound);
    if (bound < reach_ && on_rim(p)) try_rim(origin.face, from, crossed ? bound : infinite);
  }

  GABARIT_HD const Vec3d& corner(std::uint32_t facet, std::size_t i) const {
    return view_.vertices[view_.facet_corners[facet][i]];
  }

  // Whether the normal of the surface counts anywhere under the facet.
  GABARIT_HD bool can_count(const Primitive& p) const {
    const double turn = static_cast<double>(view_.facet_turns[p.id]) + 1e-6;
    if (angle_ + turn >= pi) return true;
    double facing = dot(p.normal, pencil_.direction);
    if (!p.is_facet()) {
      const Vec3d a = corner(p.id, 0);
      const Vec3d n = normalized(cross(corner(p.id, 1) - a, corner(p.id, 2) - a));
      if (n == Vec3d{}) return true;
      facing = dot(n, axis_);
    }
    return facing >= least_facing_ || facing >= cosine(angle_ + turn);
  }

  // What there is no more to find on a face.
  enum class Known { nothing, feet, all };
  GABARIT_HD Known known_of(FaceId face) const {
    for (int i = solved_count_ - 1; i >= 0; --i)
      if (solved_[i] == face) return closed_part(face);
    return Known::nothing;
  }
  GABARIT_HD Known closed_part(FaceId id) const {
    const Face& face = view_.brep.faces[id];
    const SurfaceKind kind = view_.brep.surfaces[face.surface].kind;
    if (!has_closed_feet(kind) || !std::isfinite(face.range.v1 - face.range.v0)) return Known::nothing;
    return has_closed_rim(kind) ? Known::all : Known::feet;
  }

  // All feet, the rim and the tip of a face of a simple kind at once.
  GABARIT_SEPARATE GABARIT_HD Known solve(FaceId id) {
    const Known known = closed_part(id);
    if (known == Known::nothing) return known;
    ++best_.starts;
    const Face& face = view_.brep.faces[id];
    const Surface& surface = view_.brep.surfaces[face.surface];
    const ClosedFootSearch search(surface, pencil_, view_.size);
    ClosedFeet feet, rim;
    search.add_feet(feet);
    search.add_rim(face, axis_, least_facing_, rim);
    for (int i = 0; i < feet.count; ++i) keep_counting(id, feet.at[i], BallContact::face);
    for (int i = 0; i < rim.count; ++i) keep_counting(id, rim.at[i], BallContact::separation);
    if (surface.kind == SurfaceKind::cone) try_apex(id);
    if (solved_count_ < most_solved) solved_[solved_count_++] = id;
    return known;
  }
  GABARIT_HD void keep_counting(FaceId face, Parameters at, BallContact kind) {
    const FaceFoot foot = known_foot(view_.brep, view_.brep.faces[face], pencil_, at);
    if (foot.radius < reach_ && counts(face, foot.surface)) keep_face(face, foot, kind);
  }
  GABARIT_HD void try_apex(FaceId id) {
    const Face& face = view_.brep.faces[id];
    const Surface& cone = view_.brep.surfaces[face.surface];
    const double apex = apex_of(cone), near = 1e-6 * (face.range.v1 - face.range.v0);
    if (!(apex > face.range.v0 - near && apex < face.range.v1 + near)) return;
    keep_pole(id, known_foot(view_.brep, face, pencil_, {AxialVector(cone.axes, axis_).azimuth(), apex}));
  }

  // A place of the facet that a ball gets to: `at`, else beside a corner; false where all of them lie behind
  // the pencil's tangent plane.
  GABARIT_HD bool get_ahead(const FacetOrigin& origin, Parameters& at) const {
    const Face& face = view_.brep.faces[origin.face];
    for (int k = 0; k < 4; ++k) {
      const Parameters p = k == 0 ? at
                                  : parameters_at(origin, k == 1 ? 0.998 : 0.001, k == 2 ? 0.998 : 0.001,
                                                  k == 3 ? 0.998 : 0.001);
      if (ball_of(pencil_, face_point(view_.brep, face, p).p).ahead > 0) return at = p, true;
    }
    return false;
  }

  GABARIT_HD static double dot(const Vec3f& a, const Vec3d& b) {
    return static_cast<double>(a.x) * b.x + static_cast<double>(a.y) * b.y + static_cast<double>(a.z) * b.z;
  }
  GABARIT_HD static double dot(const Vec3d& a, const Vec3d& b) { return gabarit::dot(a, b); }

  // Whether the way to the foot led from what counts to what does not.
  GABARIT_SEPARATE GABARIT_HD bool try_face(FaceId face, Parameters from, double bound) {
    if (best_.starts >= most_starts) return leave_unexplained(bound), false;
    FaceDescent descent(view_.brep, face, pencil_, reach_, known_feet_);
    const FaceFoot foot = descent.run(from);
    ++best_.starts, best_.steps += foot.iterations;
    if (foot.above) return false;
    if (!foot.found && is_pole(view_.brep.faces[face], foot.surface)) return keep_pole(face, foot), false;
    const bool counts_there = counts(face, foot.surface);
    if (foot.found && counts_there) known_feet_.add(face, foot.at);
    if (counts_there) keep_face(face, foot, BallContact::face);
    if ((foot.found || foot.at_end) && counts_there) return false;
    const bool counted = counts(face, face_point(view_.brep, view_.brep.faces[face], from));
    if (!foot.found && !foot.at_end && (counted || counts_there)) leave_unexplained(bound);
    return counted && !counts_there;
  }

  GABARIT_HD bool counts(FaceId face, const SurfacePoint& s) const {
    const Vec3d n = outward_normal_at(view_.brep, view_.brep.faces[face], s);
    return dot(n, axis_) >= least_facing_ - facing_slack;
  }

  // The nearest contact that counts may lie where the normal turns away just far enough: on such facets only.
  GABARIT_SEPARATE GABARIT_HD void try_rim(FaceId face, Parameters from, double bound) {
    const RimDescent descent(view_.brep, face, pencil_, axis_, least_facing_, reach_, known_rims_);
    const RimFoot rim = descent.run(from);
    best_.steps += rim.iterations;
    if (rim.found || rim.above) known_rims_.add(face, rim);
    if (rim.found) return keep_face(face, rim, BallContact::separation);
    if (!rim.at_end && !rim.above) leave_unexplained(bound);
  }

  // Whether the rim may cross the facet.
  GABARIT_HD bool on_rim(const Primitive& p) const {
    if (!p.is_facet()) return true;
    const double turn = static_cast<double>(view_.facet_turns[p.id]) + 1e-6;
    return angle_ > turn && dot(p.normal, pencil_.direction) < cosine(angle_ - turn);
  }

  // The tip of a face counts when its normal does anywhere beside it.
  GABARIT_HD void keep_pole(FaceId face, const FaceFoot& foot) {
    if (!(foot.radius < reach_)) return;
    FaceFoot tip = foot;
    const auto counts_at = [&](Parameters at) {
      const SurfacePoint s = face_point(view_.brep, view_.brep.faces[face], at);
      return counts(face, s) && trim_side(view_.brep, face, at) == TrimSide::inside;
    };
    if (beside_pole(view_.brep.faces[face], foot, counts_at, tip.at))
      keep_face(face, tip, BallContact::vertex);
  }

  GABARIT_SEPARATE GABARIT_HD void keep_face(FaceId face, const FaceFoot& foot, BallContact kind) {
    if (!(foot.radius < reach_) || !far_enough(foot.surface.p, foot.radius)) return;
    if (trim_side(view_.brep, face, foot.at) == TrimSide::outside) return;
    ExactBall contact;
    contact.radius = foot.radius;
    contact.contact = foot.surface.p;
    contact.kind = kind;
    contact.face = face;
    contact.at = foot.at;
    contact.residual = foot.residual;
    contact.tolerance = view_.brep.faces[face].tolerance;
    record(contact);
  }

  GABARIT_HD void visit_piece(const Primitive& p) {
    const Vec3d& d = pencil_.direction;
    const double e = static_cast<double>(p.sag) + 1e-12 * view_.size;
    const Vec3d a = view_.tree.corner(p, 0) - pencil_.point + e * d,
                b = view_.tree.corner(p, 1) - pencil_.point + e * d;
    double at = 0.5;
    const TangentBall ball = ball_through_segment(d, a, b, &at);
    if (!(ball.radius - e < reach_)) return;
    const EdgePiece& piece = view_.pieces[p.corner[2]];
    // Only as a reflex edge, and then only ahead of the ball's middle.
    const double deepest = (dot(d, a) > dot(d, b) ? dot(d, a) : dot(d, b)) + e;
    const bool too_shallow = deepest < (1 + least_facing_) * (ball.radius - e) * (1 - facing_slack);
    try_piece(p.corner[2], piece.first + at * (piece.last - piece.first), too_shallow);
  }

  // `shallow`: it is not reflex for a ball.
  GABARIT_SEPARATE GABARIT_HD void try_piece(std::uint32_t number, double from, bool shallow) {
    const EdgeContact contact(view_, pencil_, least_facing_, number);
    if (!contact.can_face() && (shallow || !contact.can_be_hollow())) return;
    const CurveFoot foot = contact.nearest(from);
    best_.steps += foot.iterations;
    if (!(foot.radius < reach_)) return;
    if (contact.counts(foot)) return keep_piece(number, foot);
    // Where a face counts only beside a part of the piece, the end of that part is nearest.
    for (std::size_t k = 0; k < 4; ++k) {
      CurveFoot end = foot;
      if (contact.end_of_side(k / 2, k % 2 == 0, reach_, end)) keep_piece(number, end);
    }
  }

  GABARIT_HD void keep_piece(std::uint32_t number, const CurveFoot& foot) {
    const EdgePiece& piece = view_.pieces[number];
    if (!far_enough(foot.curve.p, foot.radius)) return;
    ExactBall contact;
    contact.radius = foot.radius;
    contact.contact = foot.curve.p;
    contact.kind = foot.inside ? BallContact::edge : BallContact::vertex;
    contact.face = piece.beside[0].face;
    contact.edge = piece.edge;
    contact.piece = number;
    contact.t = foot.t;
    contact.residual = foot.inside ? foot.residual : 0;
    contact.tolerance = piece.tolerance;
    record(contact);
  }

  GABARIT_HD void visit_corner(const EdgeCorner& corner) {
    const PencilBall ball = ball_of(pencil_, corner.point);
    if (!(ball.radius < reach_) || !far_enough(corner.point, ball.radius)) return;
    const Vec3d w = ball.arm / ball.radius;
    if (dot(w, pencil_.direction) < least_facing_ - facing_slack) return;
    if (view_.side * dot(corner.outward, w) < 0) return;
    for (std::uint32_t i = 0; i < corner.direction_count; ++i)
      if (dot(view_.directions[corner.first_direction + i], w) < -1e-6) return;
    ExactBall contact;
    contact.radius = ball.radius;
    contact.contact = corner.point;
    contact.kind = BallContact::vertex;
    record(contact);
  }

  const ExactView& view_;
  const ExactBallOptions& options_;
  Pencil pencil_;
  Vec3d axis_;                   // that outward normals are compared with
  double least_facing_, angle_;  // the cosine and the angle up to which they count
  SphereCulling<false> culling_;
  ExactBall best_;
  double reach_ = 0, loose_facing_ = -1, unexplained_ = infinite;
  KnownFeet known_feet_;
  KnownRimFeet known_rims_;
  static constexpr int most_solved = 16;
  FaceId solved_[most_solved] = {};
  int solved_count_ = 0;
};

}  // namespace gabarit
