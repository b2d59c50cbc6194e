#include "checks/edge_chords.h"

#include <algorithm>
#include <cmath>

#include "gpu/parallel_for.h"
#include "model/brep_tangent_ball.h"

namespace gabarit {
namespace {

constexpr double most_turn = 0.15;  // radians between the ends of a chord
constexpr int deepest = 12;         // halvings of an edge
constexpr double margin = 1.5;      // of the true greatest distance to the chord over that of the samples

class Chords {
 public:
  explicit Chords(const Model& model)
      : brep_(*model.brep), arrays_(view(brep_)), corners_(brep_.faces.size()) {
    const TriangleMesh& mesh = model.mesh;
    for (FacetId f = 0; f < mesh.facet_count(); ++f) {
      const FacetOrigin& origin = brep_.facets[f];
      for (std::size_t k = 0; k < 3; ++k)
        corners_[origin.face].push_back({mesh.corner(f, static_cast<int>(k)), origin.corners[k]});
    }
  }

  void add(EdgeId e) {
    const Edge& edge = brep_.edges[e];
    if (edge.curve == no_number || edge.faces[0] == no_number) return;
    if (edge.faces[0] == edge.faces[1] && edge.kind == EdgeKind::smooth) return;  // a seam
    if (!std::isfinite(edge.first) || !std::isfinite(edge.last) || !(edge.first < edge.last)) return;
    const bool straight = brep_.curves[edge.curve].kind == CurveKind::line;
    const double middle = (edge.first + edge.last) / 2;
    if (straight) return cut(e, edge.first, edge.last, deepest);
    cut(e, edge.first, middle, 0);
    cut(e, middle, edge.last, 0);
  }

  EdgeChords done(const Device& device) {
    surface_.fan_first = {0, 0};
    return {Bvh(device, std::move(surface_)), std::move(chords_)};
  }

 private:
  struct Corner {
    Vec3d point;
    Parameters at;
  };

  CurvePoint point(EdgeId e, double t) const {
    return curve_point(arrays_, brep_.curves[brep_.edges[e].curve], t);
  }

  void cut(EdgeId e, double first, double last, int depth) {
    const CurvePoint a = point(e, first), b = point(e, last), m = point(e, (first + last) / 2);
    const auto turn = [](const Vec3d& x, const Vec3d& y) {
      return std::atan2(length(cross(x, y)), dot(x, y));
    };
    if (depth < deepest && turn(a.d, m.d) + turn(m.d, b.d) > most_turn) {
      cut(e, first, (first + last) / 2, depth + 1);
      return cut(e, (first + last) / 2, last, depth + 1);
    }
    add_chord(e, first, last);
  }

  void add_chord(EdgeId e, double first, double last) {
    const Edge& edge = brep_.edges[e];
    EdgeChord chord{.edge = e, .first = first, .last = last, .at = {}};
    const Vec3d a = point(e, first).p, b = point(e, last).p;
    double sag = 0;
    for (const double part : {0.25, 0.5, 0.75}) {
      const Vec3d p = point(e, first + part * (last - first)).p;
      sag = std::max(sag, length(p - a - part * (b - a)));
    }
    for (std::size_t side = 0; side < 2; ++side) {
      if (edge.faces[side] == no_number) continue;
      chord.at[side] = {on_face(edge.faces[side], a), on_face(edge.faces[side], b)};
      add_normals(side, (first + last) / 2, chord);
    }
    const auto id = static_cast<std::uint32_t>(chords_.size());
    const auto corner = static_cast<std::uint32_t>(surface_.points.size());
    surface_.points.push_back(a), surface_.points.push_back(b);
    surface_.primitives.push_back({.corner = {corner, corner + 1, 0},
                                   .id = id,
                                   .normal = {},
                                   .sag = static_cast<float>(margin * sag + edge.tolerance)});
    chords_.push_back(chord);
  }

  void add_normals(std::size_t side, double middle, EdgeChord& chord) const {
    const FaceId face = brep_.edges[chord.edge].faces[side];
    const auto [a, b] = chord.at[side];
    const Vec3d p = point(chord.edge, middle).p;
    const Parameters m =
        nearest_parameters(arrays_, brep_.faces[face], p, {(a.u + b.u) / 2, (a.v + b.v) / 2});
    const auto normal = [&](Parameters at) {
      return outward_normal(face_point(arrays_, brep_.faces[face], at), brep_.faces[face].sign);
    };
    const Vec3d n = chord.normal[side] = normal(m);
    for (const Parameters& end : {a, b}) {
      const Vec3d other = normal(end);
      if (other != Vec3d{})
        chord.lean = std::max(chord.lean, std::atan2(length(cross(n, other)), dot(n, other)));
    }
  }

  Parameters on_face(FaceId face, const Vec3d& p) const {
    const std::vector<Corner>& corners = corners_[face];
    if (corners.empty()) return {};
    const auto nearest =
        std::min_element(corners.begin(), corners.end(), [&](const Corner& x, const Corner& y) {
          return squared_length(x.point - p) < squared_length(y.point - p);
        });
    return nearest_parameters(arrays_, brep_.faces[face], p, nearest->at);
  }

  const Brep& brep_;
  BrepView arrays_;
  std::vector<std::vector<Corner>> corners_;  // by face
  FacetSurface surface_;
  std::vector<EdgeChord> chords_;
};

}  // namespace

EdgeChords edge_chords(const Model& model, const Device& device) {
  Chords chords(model);
  for (EdgeId e = 0; e < model.brep->edges.size(); ++e) chords.add(e);
  return chords.done(device);
}

std::vector<float> facet_leans(const Model& model, const Device& device) {
  const Brep& brep = *model.brep;
  const BrepView arrays = view(brep);
  std::vector<float> leans(brep.facets.size());
  const auto lean = [&](std::int64_t i) {
    constexpr std::array<std::array<double, 2>, 4> places{{{1. / 3, 1. / 3}, {0, 0}, {1, 0}, {0, 1}}};
    const auto f = static_cast<FacetId>(i);
    const FacetOrigin& origin = brep.facets[f];
    const Face& face = brep.faces[origin.face];
    const Vec3d own = facet_normal(model.mesh, f);
    double widest = 0;
    for (const auto& [v, w] : places) {
      const Vec3d n =
          outward_normal(face_point(arrays, face, parameters_at(origin, 1 - v - w, v, w)), face.sign);
      if (n != Vec3d{}) widest = std::max(widest, std::atan2(length(cross(own, n)), dot(own, n)));
    }
    leans[f] = static_cast<float>(widest);
  };
  parallel_for_cpu(device, static_cast<std::int64_t>(leans.size()), lean, 1024);
  return leans;
}

}  // namespace gabarit
