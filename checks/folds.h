// The edges of the facets near a region, each with the angle by which the surface turns across it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "checks/scene.h"

namespace gabarit {

// rad: an edge that turns by less is in one plane; a rounding of 10 m on facets of 1 mm.
constexpr double smallest_turn = 1e-4;

struct Fold {
  FacetId facet;         // on the other side
  std::uint8_t edge;     // of the facet asked about
  std::uint8_t other;    // edge of the facet on the other side
  bool oriented = true;  // the two facets agree about which side is outside
  bool convex = false;   // turns outwards by more than rounding of the coordinates can
  // Whether the surface turns on beyond the facet asked about, and beyond the other; where it does not, the
  // fold is the rim of a plane.
  bool turns_here = false;
  bool turns_there = false;
  float turn = 0;   // rad between the normals; positive: convex. Not oriented: as if the other were flipped
  float noise = 0;  // what rounding the coordinates to float can do to `turn`, rad
};

inline bool is_rim_here(const Fold& fold) { return fold.convex && !fold.turns_here; }
inline bool is_rim_there(const Fold& fold) { return fold.convex && !fold.turns_there; }

// A facet's edge as seen from one of its sides: lengths in the facet's plane, mm.
struct FacetEdge {
  Vec3d from, to, apex;
  double length = 0;  // of the edge
  double foot = 0;    // of the apex, from `from` along the edge
  double height = 0;  // of the apex over the edge
};
FacetEdge facet_edge(const TriangleMesh& mesh, FacetId f, int edge);

class Folds {
 public:
  // Of `facets` and all facets within `rings` edges of them. `sag`: of the facets from the true surface, mm.
  Folds(const Scene& scene, std::span<const FacetId> facets, int rings, double sag);

  // Empty for facets further away. In the order of the adjacency.
  std::span<const Fold> of(FacetId f) const {
    const std::uint32_t row = row_[f];
    return row == 0 ? std::span<const Fold>()
                    : std::span(folds_).subspan(first_[row - 1], first_[row] - first_[row - 1]);
  }
  // The facets asked about and those within `rings` edges, ascending.
  std::vector<FacetId> within(std::span<const FacetId> facets, int rings) const;
  // Bodies whose facets look inwards: none of their folds are oriented.
  const std::vector<std::uint32_t>& inside_out() const { return inside_out_; }

 private:
  void fill(const Scene& scene, const Adjacency& adjacency);
  void find_rims(const Scene& scene, double sag);
  bool turns_beyond(const TriangleMesh& mesh, FacetId f, int edge) const;

  std::vector<std::uint32_t> inside_out_;
  std::vector<FacetId> facets_;
  std::vector<std::uint32_t> row_;  // by facet: row + 1 in first_, 0 when further away
  std::vector<std::uint64_t> first_;
  std::vector<Fold> folds_;
};

}  // namespace gabarit
