// One exact ball: starts from facets and chords in turn until none is left that could make it smaller.
#pragma once

#include "checks/ball_starts.h"
#include "checks/exact_ball.h"
#include "model/brep_tangent_ball.h"

namespace gabarit {

// Facets lean away from the normals of the surface by up to half the angle that OpenCASCADE is asked for.
constexpr double facet_lean = 0.19;  // radians

struct FaceOfFacet {
  static constexpr bool of_facets = true;
  View<const FacetOrigin> origins;
  GABARIT_HD FaceId operator()(std::uint32_t id) const { return origins[id].face; }
};
struct EdgeOfChord {
  static constexpr bool of_facets = false;
  View<const EdgeChord> chords;
  GABARIT_HD EdgeId operator()(std::uint32_t id) const { return chords[id].edge; }
};

class ExactBallSearch {
 public:
  GABARIT_HD ExactBallSearch(const ExactBallScene& scene, const ExactBallOptions& options,
                             const ExactBallQuery& query)
      : scene_(scene), options_(options), query_(query), bound_(options.greatest_radius) {
    if (options.cos_separation >= 1 && query.own_curvature > 0 && 1 / query.own_curvature < bound_) {
      bound_ = ball.radius = 1 / query.own_curvature;
      ball.kind = BallContact::curvature, ball.contact = query.point;
      ball.face = scene.origins[query.facet].face, ball.verified = true;
    }
  }

  // From where a neighbouring query found its contact.
  GABARIT_HD void warm_up(const ExactBall& neighbour) {
    if (neighbour.kind == BallContact::face) try_face(neighbour.face, neighbour.at);
  }

  GABARIT_HD void run() {
    TriedStarts facets, chords;
    bool more = true;
    while (more && !facets.full() && !chords.full()) {
      more = next_facet(facets);
      if (!more) more = next_chord(chords);
    }
    ball.verified = !more && ball.kind != BallContact::separation;
  }

  ExactBall ball;

 private:
  GABARIT_HD bool eligible(const Vec3d& normal) const {
    return dot(normal, query_.direction) >= -options_.cos_separation - 1e-9;
  }

  GABARIT_HD bool next_facet(TriedStarts& tried) {
    SphereOptions slack;
    const double separation = std::acos(options_.cos_separation) - facet_lean;
    slack.cos_separation = separation > 0 ? std::cos(separation) : 1;
    const FaceOfFacet face_of{scene_.origins};
    BallStartSearch<FaceOfFacet> search(scene_.facets, slack, query_.point, query_.direction, bound_,
                                        query_.facet, tried, face_of);
    traverse(scene_.facets, search);
    if (search.start.primitive == no_child) return false;
    const Primitive& p = scene_.facets.primitives[search.start.primitive];
    const FacetOrigin& origin = scene_.origins[p.id];
    tried.add(p.id, origin.face);
    try_face(origin.face, parameters_of(p, origin, search.start.contact));
    return true;
  }

  GABARIT_HD Parameters parameters_of(const Primitive& p, const FacetOrigin& origin, const Vec3d& q) const {
    const Vec3d a = scene_.facets.corner(p, 0) - query_.point;
    const Vec3d ab = scene_.facets.corner(p, 1) - query_.point - a,
                ac = scene_.facets.corner(p, 2) - query_.point - a, aq = q - a;
    const Vec3d n = cross(ab, ac);
    const double area = squared_length(n);
    const double v = dot(cross(aq, ac), n) / area, w = dot(cross(ab, aq), n) / area;
    return parameters_at(origin, 1 - v - w, v, w);
  }

  GABARIT_HD void try_face(FaceId id, Parameters start) {
    const Face& face = scene_.brep.faces[id];
    const BallFoot foot = foot_on_surface(scene_.brep, face, query_.point, query_.direction, start);
    count(foot);
    if (!(foot.radius < bound_)) return;
    if (!faces_away(face, foot.at)) return try_separation(id, start, foot.at);
    if (trim_side(scene_.brep, id, foot.at) == TrimSide::inside)
      record(foot, BallContact::face, id, no_number, face.tolerance);
  }

  GABARIT_HD bool faces_away(const Face& face, Parameters at) const {
    const SurfacePoint s = face_point(scene_.brep, face, at);
    return eligible(outward_normal(s, options_.sign * face.sign));
  }

  // Downhill the normal turns too little at last: the way there is followed as far as it turns enough.
  GABARIT_HD void try_separation(FaceId id, Parameters from, Parameters to) {
    const Face& face = scene_.brep.faces[id];
    if (!faces_away(face, from)) return;
    for (int i = 0; i < 30; ++i) {
      const Parameters middle{(from.u + to.u) / 2, (from.v + to.v) / 2};
      (faces_away(face, middle) ? from : to) = middle;
    }
    if (trim_side(scene_.brep, id, from) != TrimSide::inside) return;
    BallFoot foot;
    foot.at = from, foot.contact = face_point(scene_.brep, face, from).p;
    foot.radius = ball_radius(foot.contact - query_.point, query_.direction);
    record(foot, BallContact::separation, id, no_number, face.tolerance);
  }

  GABARIT_HD bool next_chord(TriedStarts& tried) {
    const SphereOptions any;
    const EdgeOfChord edge_of{scene_.chords};
    BallStartSearch<EdgeOfChord> search(scene_.edges, any, query_.point, query_.direction, bound_, no_child,
                                        tried, edge_of);
    traverse(scene_.edges, search);
    if (search.start.primitive == no_child) return false;
    const Primitive& p = scene_.edges.primitives[search.start.primitive];
    const EdgeChord& chord = scene_.chords[p.id];
    tried.add(p.id, chord.edge);
    const Vec3d a = scene_.edges.corner(p, 0) - query_.point, b = scene_.edges.corner(p, 1) - query_.point;
    double part = 0;
    ball_through_segment(query_.direction, a, b, &part);
    try_edge(chord, part);
    return true;
  }

  GABARIT_HD void try_edge(const EdgeChord& chord, double part) {
    const Edge& edge = scene_.brep.edges[chord.edge];
    const BallFoot foot = foot_on_edge(scene_.brep, edge, query_.point, query_.direction,
                                       chord.first + part * (chord.last - chord.first));
    count(foot);
    if (!(foot.radius < bound_) || !touches(edge, chord, foot)) return;
    const double end = 1e-12 * (edge.last - edge.first);
    const bool at_end = foot.at.u <= edge.first + end || foot.at.u >= edge.last - end;
    record(foot, at_end ? BallContact::vertex : BallContact::edge, edge.faces[0], chord.edge, edge.tolerance);
  }

  // Whether one of the edge's faces counts there or, on a reflex edge, the direction of the ball itself.
  GABARIT_HD bool touches(const Edge& edge, const EdgeChord& chord, const BallFoot& foot) const {
    const double part = (foot.at.u - chord.first) / (chord.last - chord.first);
    Vec3d normal[2];
    for (std::size_t side = 0; side < 2; ++side) {
      if (edge.faces[side] == no_number) continue;
      const Face& face = scene_.brep.faces[edge.faces[side]];
      const Parameters a = chord.at[side][0], b = chord.at[side][1];
      const Parameters at = nearest_parameters(scene_.brep, face, foot.contact,
                                               {a.u + part * (b.u - a.u), a.v + part * (b.v - a.v)});
      normal[side] = outward_normal(face_point(scene_.brep, face, at), options_.sign * face.sign);
      if (normal[side] != Vec3d{} && eligible(normal[side])) return true;
    }
    const bool reflex = edge.kind == EdgeKind::mixed ||
                        edge.kind == (options_.sign > 0 ? EdgeKind::concave : EdgeKind::convex);
    if (!reflex) return false;
    const Vec3d outward = (foot.contact - query_.point - foot.radius * query_.direction) / foot.radius;
    if (!eligible(outward)) return false;
    // Between the normals of its faces: the surface leaves the ball on both sides.
    const Vec3d across = cross(normal[0], normal[1]);
    return dot(cross(normal[0], outward), across) >= -1e-9 && dot(cross(outward, normal[1]), across) >= -1e-9;
  }

  GABARIT_HD void count(const BallFoot& foot) {
    ++ball.starts;
    ball.steps = static_cast<std::uint16_t>(ball.steps + foot.steps);
  }

  GABARIT_HD void record(const BallFoot& foot, BallContact kind, FaceId face, EdgeId edge, double tolerance) {
    if (!(foot.radius < bound_)) return;
    if (!(length(foot.contact - query_.point) > options_.contact_floor)) return;
    bound_ = ball.radius = foot.radius;
    ball.contact = foot.contact, ball.at = foot.at, ball.residual = foot.residual;
    ball.kind = kind, ball.face = face, ball.edge = edge, ball.tolerance = tolerance;
  }

  const ExactBallScene& scene_;
  const ExactBallOptions& options_;
  const ExactBallQuery& query_;
  double bound_;
};

}  // namespace gabarit
