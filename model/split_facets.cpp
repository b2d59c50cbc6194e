#include "model/split_facets.h"

#include <algorithm>
#include <cmath>

#include "model/brep_deviation.h"
#include "model/brep_ray.h"
#include "model/brep_view.h"

namespace gabarit {
namespace {

constexpr VertexId none = 0xFFFFFFFFU;

// A side of a facet, its ends in ascending order: neighbours agree about it.
struct Side {
  std::uint64_t ends;
  FacetId facet;
  std::uint8_t corner;  // from which it runs

  VertexId low() const { return static_cast<VertexId>(ends >> 32); }
  VertexId high() const { return static_cast<VertexId>(ends & 0xFFFFFFFFU); }
};

// Between the ends of a side, at `share` of the way.
Parameters along_side(const FacetOrigin& origin, int corner, double share) {
  std::array<double, 3> weight{};
  weight[static_cast<std::size_t>(corner)] = 1 - share;
  weight[static_cast<std::size_t>((corner + 1) % 3)] = share;
  return parameters_at(origin, weight[0], weight[1], weight[2]);
}
Parameters middle_of(const FacetOrigin& origin, int corner) { return along_side(origin, corner, 0.5); }

class Halving {
 public:
  Halving(const Brep& brep, double longest, FacetId first, TriangleMesh& mesh,
          std::vector<FacetOrigin>& origins)
      : brep_(&brep),
        arrays_(view(brep)),
        longest_(longest),
        first_(first),
        mesh_(&mesh),
        origins_(&origins) {}

  // One round: false when no side is too long.
  bool run(std::uint64_t most) {
    const std::vector<Side> sides = long_sides();
    too_many = mesh_->facet_count() + sides.size() > most;
    if (sides.empty() || too_many) return false;
    middles_.assign(3 * (mesh_->facet_count() - first_), {none, {}});
    const std::size_t before = mesh_->facet_count();
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
      while (end < sides.size() && sides[end].ends == sides[begin].ends) ++end;
      halve({sides.begin() + static_cast<std::ptrdiff_t>(begin),
             sides.begin() + static_cast<std::ptrdiff_t>(end)});
    }
    for (FacetId f = first_; f < before; ++f) cut(f);
    return true;
  }

  bool too_many = false;

 private:
  struct Middle {
    VertexId vertex = none;
    Parameters at;
  };

  std::vector<Side> long_sides() const {
    std::vector<Side> sides;
    for (FacetId f = first_; f < mesh_->facet_count(); ++f) {
      for (std::uint8_t k = 0; k < 3; ++k) {
        const VertexId a = mesh_->facets[f][k], b = mesh_->facets[f][(k + 1U) % 3];
        if (!(length(mesh_->vertices[b] - mesh_->vertices[a]) > longest_)) continue;
        sides.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), f, k});
      }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return a.ends != b.ends     ? a.ends < b.ends
             : a.facet != b.facet ? a.facet < b.facet
                                  : a.corner < b.corner;
    });
    return sides;
  }

  Middle& middle(const Side& side) { return middles_[3 * std::size_t{side.facet - first_} + side.corner]; }

  // Sides inside a face have the same parameters on both facets; those along an edge have their own.
  static bool inside_a_face(std::span<const Side> sides, const std::vector<FacetOrigin>& origins) {
    if (sides.size() != 2) return false;
    const FacetOrigin &a = origins[sides[0].facet], &b = origins[sides[1].facet];
    const auto at = [](const FacetOrigin& o, int k) { return o.corners[static_cast<std::size_t>(k % 3)]; };
    const Parameters p = at(a, sides[0].corner), q = at(b, sides[1].corner + 1);
    const Parameters r = at(a, sides[0].corner + 1), s = at(b, sides[1].corner);
    const auto same = [](const Parameters& x, const Parameters& y) {
      return std::fabs(x.u - y.u) + std::fabs(x.v - y.v) <= 1e-9 * (1 + std::fabs(x.u) + std::fabs(x.v));
    };
    return a.face == b.face && (same(p, q) || a.u_pole >= 0 || b.u_pole >= 0) &&
           (same(r, s) || a.u_pole >= 0 || b.u_pole >= 0);
  }

  void halve(std::span<const Side> sides) {
    const Side& one = sides.front();
    const FaceId face = (*origins_)[one.facet].face;
    Parameters at = middle_of((*origins_)[one.facet], one.corner);
    Vec3d p = face_point(arrays_, brep_->faces[face], at).p;
    const bool inside = inside_a_face(sides, *origins_);
    if (!inside) p = on_edge(sides, p);
    const auto vertex = static_cast<VertexId>(mesh_->vertices.size());
    mesh_->vertices.push_back(p);
    for (const Side& side : sides) {
      const FacetOrigin& origin = (*origins_)[side.facet];
      if (!inside) at = parameters_of(p, origin, side.corner);
      middle(side) = {vertex, at};
    }
  }

  // Parameters may run unevenly along a side: from the place where the surface is nearest to p.
  Parameters parameters_of(const Vec3d& p, const FacetOrigin& origin, int corner) const {
    constexpr int places = 8;
    const Face& face = brep_->faces[origin.face];
    Parameters start;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= places; ++i) {
      const Parameters at = along_side(origin, corner, static_cast<double>(i) / places);
      const double distance = squared_length(face_point(arrays_, face, at).p - p);
      if (distance < least) start = at, least = distance;
    }
    return nearest_parameters(arrays_, face, p, start);
  }

  // The point of the edge's curve nearest to the middle of the chord; `p` when no edge is near.
  Vec3d on_edge(std::span<const Side> sides, const Vec3d& p) const {
    const Vec3d a = mesh_->vertices[sides.front().low()], b = mesh_->vertices[sides.front().high()];
    const Vec3d chord = (a + b) / 2.0;
    const FaceId face = (*origins_)[sides.front().facet].face;
    const FaceId other = sides.size() > 1 ? (*origins_)[sides[1].facet].face : no_number;
    Vec3d best = p;
    double least = length(b - a) / 2;
    for (std::uint32_t i = brep_->first_edge_of_face[face]; i < brep_->first_edge_of_face[face + 1]; ++i) {
      const Edge& edge = brep_->edges[brep_->edges_of_face[i]];
      if (edge.curve == no_number || (edge.faces[0] == face ? edge.faces[1] : edge.faces[0]) != other)
        continue;
      const Vec3d there =
          curve_point(arrays_, brep_->curves[edge.curve], nearest_on_edge(arrays_, edge, chord)).p;
      const double distance = length(there - chord);
      // A side belongs to an edge when both its ends lie there.
      if (distance < least && lies_on(edge, a) && lies_on(edge, b)) best = there, least = distance;
    }
    return best;
  }
  bool lies_on(const Edge& edge, const Vec3d& p) const {
    return distance_to_edge(arrays_, edge, p) <= 2 * edge.tolerance + 1e-6;
  }

  // Replaces a facet by two, three or four.
  void cut(FacetId f) {
    const std::size_t at = 3 * std::size_t{f - first_};
    const std::array<Middle, 3> m{middles_[at], middles_[at + 1], middles_[at + 2]};
    const auto cuts = std::count_if(m.begin(), m.end(), [](const Middle& x) { return x.vertex != none; });
    if (cuts == 0) return;
    const std::array<VertexId, 3> v = mesh_->facets[f];
    const FacetOrigin origin = (*origins_)[f];
    Parts parts{this, f, origin, mesh_->body_of(f)};
    const auto corner = [&](std::size_t k) {
      return Corner{v[k % 3], origin.corners[k % 3], static_cast<int>(k % 3)};
    };
    const auto half = [&](std::size_t k) { return Corner{m[k % 3].vertex, m[k % 3].at, -1}; };
    if (cuts == 3) {
      for (std::size_t k = 0; k < 3; ++k) parts.add(corner(k), half(k), half(k + 2));
      return parts.add(half(0), half(1), half(2));
    }
    std::size_t k = 0;  // the first cut side behind an uncut one
    while (m[k].vertex == none || m[(k + 2) % 3].vertex != none) ++k;
    if (cuts == 1) {
      parts.add(corner(k), half(k), corner(k + 2));
      return parts.add(half(k), corner(k + 1), corner(k + 2));
    }
    parts.add(half(k), corner(k + 1), half(k + 1));
    // Of the two ways to cut what is left the one with the shorter diagonal.
    const auto place = [&](const Corner& c) { return mesh_->vertices[c.vertex]; };
    if (length(place(corner(k)) - place(half(k + 1))) <= length(place(half(k)) - place(corner(k + 2)))) {
      parts.add(corner(k), half(k), half(k + 1));
      return parts.add(corner(k), half(k + 1), corner(k + 2));
    }
    parts.add(corner(k), half(k), corner(k + 2));
    parts.add(half(k), half(k + 1), corner(k + 2));
  }

  struct Corner {
    VertexId vertex;
    Parameters at;
    int old;  // corner of the facet that is cut; -1: new
  };

  // The first part takes the place of the facet that is cut.
  struct Parts {
    Halving* halving;
    FacetId facet;
    FacetOrigin origin;
    std::uint32_t body;
    bool begun = false;

    void add(const Corner& a, const Corner& b, const Corner& c) {
      const std::array corners{a, b, c};
      FacetOrigin part{.face = origin.face, .corners = {a.at, b.at, c.at}};
      for (std::size_t i = 0; i < 3; ++i) {
        if (corners[i].old >= 0 && corners[i].old == origin.u_pole) part.u_pole = static_cast<std::int8_t>(i);
        if (corners[i].old >= 0 && corners[i].old == origin.v_pole) part.v_pole = static_cast<std::int8_t>(i);
      }
      TriangleMesh& mesh = *halving->mesh_;
      if (!begun) {
        mesh.facets[facet] = {a.vertex, b.vertex, c.vertex}, (*halving->origins_)[facet] = part;
        begun = true;
        return;
      }
      mesh.facets.push_back({a.vertex, b.vertex, c.vertex});
      mesh.body.push_back(body);
      halving->origins_->push_back(part);
    }
  };

  const Brep* brep_;
  BrepView arrays_;
  double longest_;
  FacetId first_;
  TriangleMesh* mesh_;
  std::vector<FacetOrigin>* origins_;
  std::vector<Middle> middles_;  // by side of the facets from first_ on
};

}  // namespace

bool split_facets(const Brep& brep, double longest, std::uint64_t most, FacetId first, TriangleMesh& mesh,
                  std::vector<FacetOrigin>& origins) {
  Halving halving(brep, longest, first, mesh, origins);
  // Every round halves, unless a surface is wild.
  for (int round = 0; round < 40 && halving.run(most); ++round) {
    for (FacetId f = first; f < mesh.facet_count(); ++f) settle_poles(brep, origins[f]);
  }
  return !halving.too_many;
}

}  // namespace gabarit
