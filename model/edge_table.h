// The edges of a mesh, each with the half-edges that lie on it: linear time, eight bytes a half-edge.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "model/triangle_mesh.h"

namespace gabarit {

// Half-edge h is edge h % 3 of facet h / 3; it runs from that corner to the next.
using HalfEdgeId = std::uint32_t;

class EdgeTable {
 public:
  // Of all facets with a normal; with `vertices` (one flag a vertex), only edges whose two ends are both
  // flagged.
  explicit EdgeTable(const TriangleMesh& mesh, const std::vector<bool>* vertices = nullptr);

  // Calls visit(span of half-edges) for every edge; half-edges ascend.
  template <class Visit>
  void for_each_edge(Visit&& visit) const {
    for (std::size_t begin = 0; begin < half_edges_.size();) {
      std::size_t end = begin + 1;
      while (end < half_edges_.size() && same_edge(begin, end)) ++end;
      visit(std::span(half_edges_).subspan(begin, end - begin));
      begin = end;
    }
  }

 private:
  // Lower number first.
  std::pair<VertexId, VertexId> ends(HalfEdgeId h) const {
    const auto& corners = mesh_->facets[h / 3];
    const VertexId from = corners[h % 3], to = corners[h % 3 == 2 ? 0 : h % 3 + 1];
    return from < to ? std::pair(from, to) : std::pair(to, from);
  }
  bool same_edge(std::size_t i, std::size_t j) const { return ends(half_edges_[i]) == ends(half_edges_[j]); }

  const TriangleMesh* mesh_;
  std::vector<HalfEdgeId> half_edges_;  // sorted by lower end, higher end, number
};

// Whether two half-edges of one edge run opposite ways round, as on an oriented surface.
bool run_opposite(const TriangleMesh& mesh, HalfEdgeId a, HalfEdgeId b);

}  // namespace gabarit
