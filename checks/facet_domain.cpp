#include "checks/facet_domain.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/brep_trim.h"

namespace gabarit {
namespace {

constexpr double hair = 1e-12;  // of a facet's area, for what is rounded
constexpr double near = 0.01;   // of the facet's box: corners lie on a curve that is no farther away

// Where a corner lies on a curved piece.
struct Place {
  const TrimPiece* piece;
  Parameters foot;       // in the corner's turn
  Parameters low, high;  // the piece's ends, likewise
  bool at_end;
};

void widen(ParameterBox& box, Parameters p) {
  box = {std::min(box.u0, p.u), std::max(box.u1, p.u), std::min(box.v0, p.v), std::max(box.v1, p.v)};
}

class Bulges {
 public:
  Bulges(const Brep& brep, FacetId facet)
      : brep_(&brep),
        arrays_(view(brep)),
        facet_(&brep.facets[facet]),
        face_(facet_->face),
        surface_(&brep.surfaces[brep.faces[face_].surface]) {
    const auto& c = facet_->corners;
    own_ = {c[0].u, c[0].u, c[0].v, c[0].v};
    for (const Parameters& p : c) widen(own_, p);
    box_ = own_;
    const double size = std::fabs(own_.u0) + std::fabs(own_.v0) + 1;
    near_ = {near * (own_.u1 - own_.u0) + 1e-12 * size, near * (own_.v1 - own_.v0) + 1e-12 * size};
  }

  ParameterBox box() const { return box_; }

  // Whether the face ends at the straight line between the corners; if not, the box takes in what is beyond.
  bool take_side(std::size_t k) {
    const std::vector<Place> from = places(facet_->corners[k]), to = places(facet_->corners[(k + 1) % 3]);
    const auto inner = [](const Place& p) { return !p.at_end; };
    const bool any_inner =
        std::any_of(from.begin(), from.end(), inner) || std::any_of(to.begin(), to.end(), inner);
    if (from.empty() && to.empty()) return true;
    if (take_common(from, to) || take_turn(from, to)) return false;
    if (!any_inner) return true;  // a straight piece between the ends of curves
    if (!from.empty() && !to.empty()) return take_all_around(), false;
    for (const Place& p : from.empty() ? to : from) {
      if (p.at_end) continue;
      const Parameters& q = facet_->corners[from.empty() ? k : (k + 1) % 3];
      widen(box_, p.foot), widen(box_, distance(p.low, q) < distance(p.high, q) ? p.low : p.high);
    }
    return false;
  }

 private:
  double distance(Parameters p, Parameters q) const {
    return std::max(std::fabs(p.u - q.u) / near_.u, std::fabs(p.v - q.v) / near_.v);
  }

  // Both on one piece: it lies between them.
  bool take_common(const std::vector<Place>& from, const std::vector<Place>& to) {
    bool any = false;
    for (const Place& p : from) {
      for (const Place& q : to) {
        if (p.piece != q.piece) continue;
        widen(box_, p.foot), widen(box_, q.foot);
        any = true;
      }
    }
    return any;
  }

  // On two that share an end.
  bool take_turn(const std::vector<Place>& from, const std::vector<Place>& to) {
    bool any = false;
    for (const Place& p : from) {
      for (const Place& q : to) {
        for (const Parameters& a : {p.low, p.high}) {
          for (const Parameters& b : {q.low, q.high}) {
            if (distance(a, b) > 1) continue;
            widen(box_, p.foot), widen(box_, a), widen(box_, b), widen(box_, q.foot);
            any = true;
          }
        }
      }
    }
    return any;
  }

  void take_all_around() {
    const double u = own_.u1 - own_.u0, v = own_.v1 - own_.v0;
    widen(box_, {own_.u0 - u, own_.v0 - v}), widen(box_, {own_.u1 + u, own_.v1 + v});
  }

  std::vector<Place> places(Parameters p) const {
    std::vector<Place> found;
    const FaceTrim& trim = brep_->trims[face_];
    for (std::uint32_t i = 0; i < trim.piece_count; ++i) {
      const TrimPiece& piece = brep_->trim_pieces[trim.first_piece + i];
      if (piece.curve == no_number || piece.seam) continue;
      if (const auto place = on(piece, p)) found.push_back(*place);
    }
    return found;
  }

  // The whole turns from p to the middle of the piece.
  static double turns(double p, double a, double b, double period) {
    return period > 0 ? period * std::round(((a + b) / 2 - p) / period) : 0;
  }

  std::optional<Place> on(const TrimPiece& piece, Parameters p) const {
    const double u_turn = turns(p.u, piece.a.u, piece.b.u, u_period(*surface_)),
                 v_turn = turns(p.v, piece.a.v, piece.b.v, v_period(*surface_));
    p.u += u_turn, p.v += v_turn;
    const auto [u0, u1] = std::minmax(piece.a.u, piece.b.u);
    if (p.u < u0 - near_.u || p.u > u1 + near_.u || p.v < piece.a.v - near_.v || p.v > piece.b.v + near_.v)
      return std::nullopt;
    const Parameters foot = foot_on(piece, p);
    if (distance(foot, p) > 1) return std::nullopt;
    const auto back = [&](Parameters q) { return Parameters{q.u - u_turn, q.v - v_turn}; };
    return Place{&piece, back(foot), back(piece.a), back(piece.b),
                 std::min(distance(foot, piece.a), distance(foot, piece.b)) <= 1};
  }

  // With the parameter of p in which the piece is longer.
  Parameters foot_on(const TrimPiece& piece, Parameters p) const {
    const bool by_v = (piece.b.v - piece.a.v) / near_.v >= std::fabs(piece.b.u - piece.a.u) / near_.u;
    const bool falls = !by_v && piece.b.u < piece.a.u;
    const auto below = [&](Parameters q) { return by_v ? q.v < p.v : falls ? q.u > p.u : q.u < p.u; };
    if (!below(piece.a)) return piece.a;
    if (below(piece.b)) return piece.b;
    Parameters foot = piece.a;
    double low = piece.first, high = piece.last;
    for (int step = 0; step < 40; ++step) {
      const double middle = low + (high - low) / 2;
      foot = trim_point(arrays_, brep_->curves[piece.curve], middle);
      (below(foot) ? low : high) = middle;
    }
    return foot;
  }

  const Brep* brep_;
  BrepView arrays_;
  const FacetOrigin* facet_;
  FaceId face_;
  const Surface* surface_;
  ParameterBox own_, box_;
  Parameters near_;
};

// Whether the facet goes on there in the same face with the same parameters.
bool goes_on(const Brep& brep, HalfEdgeId h, HalfEdgeId other) {
  const FacetOrigin &f = brep.facets[h / 3], &g = brep.facets[other / 3];
  if (h == other || f.face != g.face) return false;
  for (const std::uint32_t end : {0U, 1U}) {
    const Parameters p = f.corners[(h + end) % 3], q = g.corners[(other + 1 - end) % 3];
    if (p.u != q.u || p.v != q.v) return false;
  }
  return true;
}

double side_of(Parameters a, Parameters b, double u, double v) {
  return (b.u - a.u) * (v - a.v) - (b.v - a.v) * (u - a.u);
}

}  // namespace

FacetDomain facet_domain(const Brep& brep, FacetId facet, const std::array<HalfEdgeId, 3>& other) {
  const FacetOrigin& origin = brep.facets[facet];
  const bool has_pole = origin.u_pole >= 0 || origin.v_pole >= 0;
  Bulges bulges(brep, facet);
  FacetDomain domain;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool inside = goes_on(brep, 3 * facet + static_cast<HalfEdgeId>(k), other[k]);
    domain.straight[k] = (inside || bulges.take_side(k)) && !has_pole;
  }
  domain.box = bulges.box();
  return domain;
}

bool in_triangle(const FacetOrigin& facet, Parameters p) {
  const auto& c = facet.corners;
  const double whole = side_of(c[0], c[1], c[2].u, c[2].v);
  for (std::size_t k = 0; k < 3; ++k) {
    if (side_of(c[k], c[(k + 1) % 3], p.u, p.v) * (whole > 0 ? 1 : -1) < -hair * std::fabs(whole))
      return false;
  }
  return true;
}

std::vector<Parameters> part_in(const FacetOrigin& facet, const FacetDomain& domain,
                                const ParameterBox& box) {
  const auto& c = facet.corners;
  const double whole = side_of(c[0], c[1], c[2].u, c[2].v);
  std::vector<Parameters> part{{box.u0, box.v0}, {box.u1, box.v0}, {box.u1, box.v1}, {box.u0, box.v1}};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!domain.straight[k]) continue;
    const auto depth = [&](const Parameters& p) {
      return side_of(c[k], c[(k + 1) % 3], p.u, p.v) * (whole > 0 ? 1 : -1) + hair * std::fabs(whole);
    };
    std::vector<Parameters> rest;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Parameters a = part[i], b = part[(i + 1) % part.size()];
      const double from = depth(a), to = depth(b);
      if (from >= 0) rest.push_back(a);
      if ((from >= 0) == (to >= 0)) continue;
      const double share = from / (from - to);
      rest.push_back({a.u + share * (b.u - a.u), a.v + share * (b.v - a.v)});
    }
    part = std::move(rest);
  }
  return part;
}

}  // namespace gabarit
