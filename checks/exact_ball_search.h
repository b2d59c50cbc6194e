// One exact ball: starts from facets and chords in turn until none is left that could make it smaller.
#pragma once

#include "checks/ball_starts.h"
#include "checks/exact_ball.h"
#include "checks/separation_line.h"

namespace gabarit {

GABARIT_HD inline double angle_of(double cosine) {
  return std::acos(cosine < -1 ? -1.0 : cosine > 1 ? 1.0 : cosine);
}

struct FaceOfFacet {
  static constexpr bool of_facets = true;
  View<const FacetOrigin> origins;
  View<const float> leans;
  double greatest_angle;  // between a contact's normal and the direction

  GABARIT_HD FaceId operator()(std::uint32_t id) const { return origins[id].face; }
  // Some of the surface behind the facet turns away far enough; on a face that was tried, all of it must:
  // what lies on the line between was looked at.
  GABARIT_HD bool counts(const Primitive& p, const Vec3d& direction, const TriedStarts& tried) const {
    const double facing = static_cast<double>(p.normal.x) * direction.x +
                          static_cast<double>(p.normal.y) * direction.y +
                          static_cast<double>(p.normal.z) * direction.z;
    const double angle = angle_of(facing);
    const double lean = static_cast<double>(leans[p.id]) + 1e-6;
    return angle - lean <= greatest_angle &&
           (angle + lean <= greatest_angle || !tried.has_group((*this)(p.id)));
  }
};
struct EdgeOfChord {
  static constexpr bool of_facets = false;
  View<const EdgeChord> chords;
  View<const Edge> edges;
  double sign, greatest_angle;

  GABARIT_HD EdgeId operator()(std::uint32_t id) const { return chords[id].edge; }
  GABARIT_HD bool reflex(const Edge& edge) const {
    return edge.kind == EdgeKind::mixed || edge.kind == (sign > 0 ? EdgeKind::concave : EdgeKind::convex);
  }
  // One of the faces may turn away far enough; or the edge is reflex and the ball comes from between them.
  GABARIT_HD bool counts(const Primitive& p, const Vec3d& direction, const TangentBall& ball) const {
    const EdgeChord& chord = chords[p.id];
    const double lean = chord.lean * 1.5 + 1e-6;
    for (const Vec3d& n : chord.normal)
      if (n != Vec3d{} && angle_of(sign * dot(n, direction)) - lean <= greatest_angle) return true;
    if (!reflex(edges[chord.edge])) return false;
    const Vec3d outward = (ball.contact - ball.radius * direction) / ball.radius;
    if (angle_of(dot(outward, direction)) - 0.1 > greatest_angle) return false;
    const double bend = angle_of(dot(chord.normal[0], chord.normal[1]));
    return angle_of(sign * dot(outward, chord.normal[0])) + angle_of(sign * dot(outward, chord.normal[1])) <=
           bend + 2 * lean + 0.3;
  }
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
    // A way down that leaves a face ends on its edges: they are looked at before more of its facets.
    bool more = true;
    while (more && !facets.full() && !chords.full()) {
      bool settled = false;
      more = next_facet(facets, settled);
      if (!more || !settled) more = next_chord(chords) || more;
    }
    ball.verified = !more;
  }

  ExactBall ball;

 private:
  // Between a contact's normal and the direction.
  GABARIT_HD double greatest_angle() const { return angle_of(-options_.cos_separation); }
  GABARIT_HD bool eligible(const Vec3d& normal) const {
    return dot(normal, query_.direction) >= -options_.cos_separation - 1e-9;
  }

  GABARIT_HD bool next_facet(TriedStarts& tried, bool& settled) {
    constexpr double pi = 3.14159265358979323846;
    const double angle = greatest_angle();
    SphereOptions slack;
    slack.cos_separation = angle + scene_.widest_lean < pi ? -std::cos(angle + scene_.widest_lean) : 1;
    const FaceOfFacet face_of{scene_.origins, scene_.leans, angle};
    BallStartSearch<FaceOfFacet> search(scene_.facets, slack, query_.point, query_.direction, bound_,
                                        query_.facet, tried, face_of);
    traverse(scene_.facets, search);
    if (search.start.primitive == no_child) return false;
    const Primitive& p = scene_.facets.primitives[search.start.primitive];
    const FacetOrigin& origin = scene_.origins[p.id];
    const Parameters start = eligible_start(origin, parameters_of(p, origin, search.start.contact));
    settled = faces_away(scene_.brep.faces[origin.face], start) && try_face(origin.face, start);
    if (try_line_through(origin, start)) settled = true;
    tried.add(p.id, settled ? origin.face : no_number);
    return true;
  }

  // Where the line on which the normal turns away just far enough crosses the facet, the way down from the
  // facet need not cross it: it is followed from here as well.
  GABARIT_HD bool try_line_through(const FacetOrigin& origin, Parameters start) {
    bool found = false;
    for (const Parameters& corner : origin.corners) {
      if (faces_away(scene_.brep.faces[origin.face], corner)) continue;
      if (try_separation(origin.face, start, corner)) found = true;
    }
    return found;
  }

  // A place on the facet where the surface turns away far enough, if there is one: `start`, or a corner.
  GABARIT_HD Parameters eligible_start(const FacetOrigin& origin, Parameters start) const {
    const Face& face = scene_.brep.faces[origin.face];
    if (faces_away(face, start)) return start;
    Parameters best = start;
    double least = std::numeric_limits<double>::infinity();
    for (const Parameters& corner : origin.corners) {
      if (!faces_away(face, corner)) continue;
      const double radius =
          ball_radius(face_point(scene_.brep, face, corner).p - query_.point, query_.direction);
      if (radius < least) best = corner, least = radius;
    }
    return best;
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

  // False when the way down leaves the face: then one start does not speak for the others.
  GABARIT_HD bool try_face(FaceId id, Parameters start) {
    const Face& face = scene_.brep.faces[id];
    const BallFoot foot = foot_on_surface(scene_.brep, face, query_.point, query_.direction, start);
    count(foot);
    if (!faces_away(face, foot.at)) return try_separation(id, start, foot.at);
    if (trim_side(scene_.brep, id, foot.at) != TrimSide::inside) return false;
    record(foot, BallContact::face, id, no_number, face.tolerance);
    return true;
  }

  GABARIT_HD bool faces_away(const Face& face, Parameters at) const {
    const SurfacePoint s = face_point(scene_.brep, face, at);
    return eligible(outward_normal(s, options_.sign * face.sign));
  }

  // Downhill the normal turns too little at last: the least value lies where it turns just enough. From the
  // place where the way down crosses that line, along it.
  GABARIT_HD bool try_separation(FaceId id, Parameters from, Parameters to) {
    const Face& face = scene_.brep.faces[id];
    if (!faces_away(face, from)) return false;
    for (int i = 0; i < 40; ++i) {
      const Parameters middle{(from.u + to.u) / 2, (from.v + to.v) / 2};
      (faces_away(face, middle) ? from : to) = middle;
    }
    const SeparationLine line{
        scene_.brep, face, options_.sign, query_.point, query_.direction, -options_.cos_separation};
    BallFoot foot = line.least_from(from);
    count(foot);
    if (!faces_away(face, foot.at)) {  // it ran into a pole
      foot.at = from, foot.contact = face_point(scene_.brep, face, from).p;
      foot.radius = ball_radius(foot.contact - query_.point, query_.direction);
    }
    if (trim_side(scene_.brep, id, foot.at) != TrimSide::inside) return false;
    record(foot, BallContact::separation, id, no_number, face.tolerance);
    return true;
  }

  GABARIT_HD bool next_chord(TriedStarts& tried) {
    const SphereOptions any;
    const EdgeOfChord edge_of{scene_.chords, scene_.brep.edges, options_.sign, greatest_angle()};
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
    const double start = chord.first + part * (chord.last - chord.first);
    BallFoot foot = foot_on_edge(scene_.brep, edge, query_.point, query_.direction, start);
    count(foot);
    if (!(foot.radius < bound_)) return;
    BallContact kind = BallContact::edge;
    const double end = 1e-12 * (edge.last - edge.first);
    if (foot.at.u <= edge.first + end || foot.at.u >= edge.last - end) kind = BallContact::vertex;
    if (!touches(edge, chord, foot)) {
      kind = BallContact::separation;
      foot = last_that_touches(edge, chord, start, foot);
    }
    record(foot, kind, edge.faces[0], chord.edge, edge.tolerance);
  }

  GABARIT_HD BallFoot place_on(const Edge& edge, double t) const {
    BallFoot foot;
    foot.at = {t, 0}, foot.contact = curve_point(scene_.brep, scene_.brep.curves[edge.curve], t).p;
    foot.radius = ball_radius(foot.contact - query_.point, query_.direction);
    return foot;
  }

  // On the way from the chord down to a foot that does not count; without a radius when nothing there counts.
  GABARIT_HD BallFoot last_that_touches(const Edge& edge, const EdgeChord& chord, double start,
                                        const BallFoot& foot) const {
    BallFoot best;
    const double places[3] = {start, chord.first, chord.last};
    for (const double t : places) {
      const BallFoot here = place_on(edge, t);
      if (here.radius < best.radius && touches(edge, chord, here)) best = here;
    }
    double to = foot.at.u;
    for (int i = 0; i < 40 && best.radius < std::numeric_limits<double>::infinity(); ++i) {
      const BallFoot middle = place_on(edge, (best.at.u + to) / 2);
      if (touches(edge, chord, middle))
        best = middle;
      else
        to = middle.at.u;
    }
    return best;
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
      const SurfacePoint s = face_point(scene_.brep, face, at);
      // Near a pole the search for the parameters can end elsewhere: then nothing is known of the normal.
      if (length(s.p - foot.contact) > 1e-4 + 2 * edge.tolerance) continue;
      normal[side] = outward_normal(s, options_.sign * face.sign);
      if (normal[side] != Vec3d{} && eligible(normal[side])) return true;
    }
    if (!EdgeOfChord{{}, {}, options_.sign, 0}.reflex(edge)) return false;
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
