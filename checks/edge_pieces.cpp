#include "checks/edge_pieces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "model/brep_foot_edge.h"
#include "model/edge_table.h"

namespace gabarit {
namespace {

constexpr double margin = 1.25;  // of a greatest distance over that of the samples
constexpr int places_on_curve = 24;

// The parameter of the place of a curve that is nearest to a point, and how near.
struct Projection {
  double t = 0, distance = std::numeric_limits<double>::infinity();
};

class CurveProjection {
 public:
  CurveProjection(const BrepView& brep, const Edge& edge)
      : brep_(brep), edge_(edge), curve_(brep.curves[edge.curve]) {
    const int spans = curve_.kind == CurveKind::spline ? 2 * curve_.pole_count : 1;
    count_ = std::clamp(spans, places_on_curve, 4096);
    for (int i = 0; i <= count_; ++i) places_.push_back(curve_point(brep_, curve_, parameter(i)).p);
  }

  Projection nearest(const Vec3d& p) const {
    std::size_t best = 0;
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (squared_length(places_[i] - p) < squared_length(places_[best] - p)) best = i;
    const int at = static_cast<int>(best);
    const Projection found = closed_in(p, parameter(at));
    if (!closed() || (at > 0 && at < count_)) return found;
    // Where a closed curve begins it also ends: the point may lie on either side.
    const Projection other = closed_in(p, parameter(count_ - at));
    return other.distance < found.distance ? other : found;
  }

  // From a parameter that is known to be near.
  Projection closed_in(const Vec3d& p, double t) const {
    for (int i = 0; i < 20; ++i) {
      const CurvePoint c = curve_point(brep_, curve_, t);
      const Vec3d r = c.p - p;
      const double slope = dot(r, c.d), speed = squared_length(c.d);
      const double second = speed + dot(r, c.dd);
      if (!(speed > 0)) break;
      const double next = clamped(t - slope / (second > 0.1 * speed ? second : speed));
      if (std::fabs(next - t) * std::sqrt(speed) < 1e-14 * (1 + length(p))) break;
      t = next;
    }
    return {t, length(curve_point(brep_, curve_, t).p - p)};
  }

  Vec3d point(double t) const { return curve_point(brep_, curve_, t).p; }
  bool closed() const { return squared_length(places_.front() - places_.back()) < 1e-12; }
  double first() const { return edge_.first; }
  double last() const { return edge_.last; }

 private:
  double parameter(int i) const { return edge_.first + (edge_.last - edge_.first) * i / count_; }
  double clamped(double t) const { return std::clamp(t, edge_.first, edge_.last); }

  const BrepView& brep_;
  const Edge& edge_;
  const Curve& curve_;
  int count_ = 0;
  std::vector<Vec3d> places_;
};

class Pieces {
 public:
  explicit Pieces(const Model& model) : mesh_(model.mesh), brep_(*model.brep), arrays_(view(brep_)) {
    result_.facet_sags.assign(mesh_.facet_count(), 0);
  }

  EdgePieces run() {
    EdgeTable(mesh_).for_each_edge([&](std::span<const HalfEdgeId> edge) {
      if (edge.size() == 2 && run_opposite(mesh_, edge[0], edge[1])) {
        if (face_of(edge[0]) != face_of(edge[1])) add(edge[0], edge[1]);
      } else {
        for (const HalfEdgeId h : edge) add(h, std::nullopt);
      }
    });
    return std::move(result_);
  }

 private:
  const FacetOrigin& origin(HalfEdgeId h) const { return brep_.facets[h / 3]; }
  FaceId face_of(HalfEdgeId h) const { return origin(h).face; }

  void add(HalfEdgeId h, std::optional<HalfEdgeId> other) {
    const FacetId f = h / 3;
    const std::array<VertexId, 2> ends{mesh_.facets[f][h % 3], mesh_.facets[f][(h + 1) % 3]};
    EdgePiece piece;
    piece.a = mesh_.vertices[ends[0]], piece.b = mesh_.vertices[ends[1]];
    std::array<std::vector<Vec3d>, 2> normals;
    piece.beside[0] = beside(h, false, normals[0]);
    if (other) piece.beside[1] = beside(*other, true, normals[1]);
    set_turns(piece, normals);
    double sag = find_curve(piece);
    sag = std::max(sag, margin * bulge(piece));
    result_.pieces.push_back(piece);
    result_.ends.push_back(ends);
    result_.sags.push_back(sag);
    for (const HalfEdgeId side : {h, other.value_or(h)})
      result_.facet_sags[side / 3] = std::max(result_.facet_sags[side / 3], sag);
  }

  EdgePiece::Beside beside(HalfEdgeId h, bool turned, std::vector<Vec3d>& normals) const {
    EdgePiece::Beside side;
    side.face = face_of(h);
    const FacetOrigin& facet = origin(h);
    side.at = {facet.corners[h % 3], facet.corners[(h + 1) % 3]};
    if (turned) std::swap(side.at[0], side.at[1]);
    set_normals(side, facet, normals);
    return side;
  }

  // The normals at both ends and in the middle; those that there are.
  void set_normals(EdgePiece::Beside& side, const FacetOrigin& facet, std::vector<Vec3d>& normals) const {
    if (side.face == no_number) return;
    const Face& face = brep_.faces[side.face];
    for (const double share : {0.0, 0.5, 1.0}) {
      const Parameters at{side.at[0].u + share * (side.at[1].u - side.at[0].u),
                          side.at[0].v + share * (side.at[1].v - side.at[0].v)};
      const Vec3d n = outward_normal(face_point(arrays_, face, at), face.sign);
      if (n != Vec3d{}) normals.push_back(n), side.mean += n;
    }
    side.mean = normalized(side.mean);
    side.spread = facet.u_pole >= 0 || facet.v_pole >= 0 || normals.size() < 3 ? 4 : 0;
    for (const Vec3d& n : normals)
      side.spread = std::max(side.spread, 2 * std::atan2(length(cross(n, side.mean)), dot(n, side.mean)));
  }

  // What lies between the three places may differ by as much as these among themselves.
  static void set_turns(EdgePiece& piece, const std::array<std::vector<Vec3d>, 2>& normals) {
    if (normals[0].size() < 3 || normals[1].size() < 3) return;
    const Vec3d along = normalized(piece.b - piece.a);
    double least = 4, greatest = -4;
    for (std::size_t i = 0; i < 3; ++i) {
      const double turn =
          std::atan2(dot(cross(normals[0][i], normals[1][i]), along), dot(normals[0][i], normals[1][i]));
      least = std::min(least, turn), greatest = std::max(greatest, turn);
    }
    const double slack = greatest - least + 1e-3;
    if (greatest + slack < 3 && least - slack > -3)  // a knife's edge looks like a slit
      piece.least_turn = least - slack, piece.greatest_turn = greatest + slack;
  }

  std::vector<EdgeId> candidates(const EdgePiece& piece) const {
    std::vector<EdgeId> found;
    const FaceId one = piece.beside[0].face, other = piece.beside[1].face;
    if (one == no_number) return found;
    for (std::uint32_t i = brep_.first_edge_of_face[one]; i < brep_.first_edge_of_face[one + 1]; ++i) {
      const Edge& e = brep_.edges[brep_.edges_of_face[i]];
      const bool fits = other == no_number || e.faces[0] == other || e.faces[1] == other;
      if (fits && e.curve != no_number && e.last > e.first) found.push_back(brep_.edges_of_face[i]);
    }
    return found;
  }

  const CurveProjection& projection(EdgeId e) {
    const auto found = projections_.find(e);
    if (found != projections_.end()) return found->second;
    return projections_.emplace(e, CurveProjection(arrays_, brep_.edges[e])).first->second;
  }

  // The curve that passes both ends. How far it lies from the straight line, mm.
  double find_curve(EdgePiece& piece) {
    double nearest = std::numeric_limits<double>::infinity(), sag = 0;
    for (const EdgeId e : candidates(piece)) {
      const CurveProjection& curve = projection(e);
      const Projection a = curve.nearest(piece.a), b = curve.nearest(piece.b);
      const double off = std::max(a.distance, b.distance);
      const double allowed = 10 * brep_.edges[e].tolerance + 1e-6;
      if (off > allowed || off >= nearest) continue;
      const auto range = between(curve, a.t, b.t, piece);
      if (!range) continue;
      nearest = off;
      piece.edge = e, piece.first = range->first, piece.last = range->second;
      piece.tolerance = brep_.edges[e].tolerance;
      sag = bend(curve, piece) + off;
    }
    if (piece.edge == no_number) piece.tolerance = bulge(piece);
    return sag;
  }

  // Of the ways round a closed curve the one that stays near the straight line.
  static std::optional<std::pair<double, double>> between(const CurveProjection& curve, double a, double b,
                                                          const EdgePiece& piece) {
    std::vector<std::pair<double, double>> ways{{a, b}};
    if (curve.closed()) {
      const double tiny = 1e-6 * (curve.last() - curve.first());
      const auto other_end = [&](double t) {
        return t - curve.first() < tiny ? curve.last() : curve.last() - t < tiny ? curve.first() : t;
      };
      ways.emplace_back(other_end(a), b);
      ways.emplace_back(a, other_end(b));
      ways.emplace_back(other_end(a), other_end(b));
    }
    const double chord = length(piece.b - piece.a);
    std::optional<std::pair<double, double>> best;
    double least = std::max(chord, 1e-9);
    for (const auto& way : ways) {
      if (way.first == way.second) continue;
      const double off = deviation(curve, way.first, way.second, piece);
      if (off < least) least = off, best = way;
    }
    return best;
  }

  static double deviation(const CurveProjection& curve, double a, double b, const EdgePiece& piece) {
    double greatest = 0;
    const Vec3d along = piece.b - piece.a;
    for (const double share : {0.25, 0.5, 0.75}) {
      const Vec3d p = curve.point(a + share * (b - a)) - piece.a;
      const double squared = squared_length(along);
      const double at = squared > 0 ? std::clamp(dot(p, along) / squared, 0.0, 1.0) : 0;
      greatest = std::max(greatest, length(p - at * along));
    }
    return greatest;
  }
  static double bend(const CurveProjection& curve, const EdgePiece& piece) {
    return margin * deviation(curve, piece.first, piece.last, piece);
  }

  // How far the surfaces beside it leave the straight line.
  double bulge(const EdgePiece& piece) const {
    double greatest = 0;
    const Vec3d middle = (piece.a + piece.b) / 2.0, along = piece.b - piece.a;
    for (const EdgePiece::Beside& side : piece.beside) {
      if (side.face == no_number) continue;
      const Parameters at{(side.at[0].u + side.at[1].u) / 2, (side.at[0].v + side.at[1].v) / 2};
      const Vec3d p = face_point(arrays_, brep_.faces[side.face], at).p;
      const double share = std::clamp(dot(p - piece.a, along) / squared_length(along), 0.0, 1.0);
      const double off = length(p - piece.a - share * along);
      if (off < length(along) && length(p - middle) < 2 * length(along)) greatest = std::max(greatest, off);
    }
    return greatest;
  }

  const TriangleMesh& mesh_;
  const Brep& brep_;
  BrepView arrays_;
  EdgePieces result_;
  std::map<EdgeId, CurveProjection> projections_;
};

// In which an edge leaves a corner.
Vec3d leaving(const BrepView& brep, const EdgePiece& piece, bool from_first) {
  const Vec3d chord = normalized(from_first ? piece.b - piece.a : piece.a - piece.b);
  if (piece.edge == no_number) return chord;
  const Curve& curve = brep.curves[brep.edges[piece.edge].curve];
  const double t = from_first ? piece.first : piece.last;
  const double sign = (piece.last > piece.first) == from_first ? 1 : -1;
  const Vec3d tangent = normalized(curve_point(brep, curve, t).d * sign);
  return tangent == Vec3d{} ? chord : tangent;
}

// How the surface leaves a corner.
struct Star {
  std::vector<Vec3d> directions, normals;
};

Vec3d agreed(const std::vector<Vec3d>& normals) {
  Vec3d sum;
  for (const Vec3d& n : normals) sum += n;
  const Vec3d mean = normalized(sum);
  for (const Vec3d& n : normals)
    if (dot(n, mean) < 0.3) return {};
  return mean;
}

}  // namespace

EdgePieces edge_pieces(const Model& model) { return Pieces(model).run(); }

EdgeCorners edge_corners(const Model& model, const EdgePieces& pieces) {
  const BrepView brep = view(*model.brep);
  std::map<VertexId, std::vector<std::pair<EdgeId, Vec3d>>> met;
  for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}})
      met[pieces.ends[i][end]].emplace_back(pieces.pieces[i].edge, leaving(brep, pieces.pieces[i], end == 0));
  }
  std::map<VertexId, Star> stars;
  for (const auto& [vertex, edges] : met) {
    if (edges.size() == 2 && edges[0].first == edges[1].first && edges[0].first != no_number) continue;
    for (const auto& edge : edges) stars[vertex].directions.push_back(edge.second);
  }
  // Inside the faces: the sides of facets, laid into the tangent plane.
  for (FacetId f = 0; f < model.mesh.facet_count(); ++f) {
    const FacetOrigin& origin = model.brep->facets[f];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto star = stars.find(model.mesh.facets[f][i]);
      if (star == stars.end() || origin.face == no_number) continue;
      const Face& face = model.brep->faces[origin.face];
      const Vec3d n = outward_normal(face_point(brep, face, origin.corners[i]), face.sign);
      const Vec3d middle = (model.mesh.corner(f, static_cast<int>((i + 1) % 3)) +
                            model.mesh.corner(f, static_cast<int>((i + 2) % 3))) /
                           2.0;
      const Vec3d w = middle - model.mesh.corner(f, static_cast<int>(i));
      star->second.directions.push_back(normalized(w - n * dot(n, w)));
      if (n != Vec3d{}) star->second.normals.push_back(n);
    }
  }
  EdgeCorners result;
  for (const auto& [vertex, star] : stars) {
    result.vertices.push_back(vertex);
    result.corners.push_back({model.mesh.vertices[vertex], agreed(star.normals),
                              static_cast<std::uint32_t>(result.directions.size()),
                              static_cast<std::uint32_t>(star.directions.size())});
    result.directions.insert(result.directions.end(), star.directions.begin(), star.directions.end());
  }
  return result;
}

}  // namespace gabarit
