// Which facets share an edge segment, also where edges only overlap (T-junctions).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/device.h"
#include "model/triangle_mesh.h"

namespace gabarit {

// Edge e of a facet runs from its corner e to its corner (e + 1) % 3.
struct EdgeNeighbour {
  FacetId facet;           // the other facet
  std::uint8_t edge;       // of the facet asked about
  std::uint8_t other;      // edge of the other facet
  bool reversed;           // the other edge runs the opposite way, as consistent orientation wants
  float from = 0, to = 1;  // the shared segment, as fractions of the edge asked about
};

class Adjacency {
 public:
  // Neighbours of `of` (all facets when empty) among all facets of the mesh. Edges that lie within
  // `tolerance` (mm) of one line and overlap by more than it are shared, whether or not they have vertices in
  // common. Degenerate and non-finite facets have no neighbours. The order is by edge, then by facet: it does
  // not depend on threads.
  explicit Adjacency(const TriangleMesh& mesh, std::span<const FacetId> of = {}, double tolerance = 1e-3,
                     const Device& device = Device::cpu(1));

  // Empty for facets that were not asked about.
  std::span<const EdgeNeighbour> of(FacetId facet) const;

 private:
  std::vector<std::uint32_t> row_;  // by facet: row + 1 in first_, 0 when not asked about
  std::vector<std::uint64_t> first_;
  std::vector<EdgeNeighbour> neighbours_;
};

}  // namespace gabarit
