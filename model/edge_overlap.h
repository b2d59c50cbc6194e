// Edges that lie on one line and overlap without having both ends in common: T-junctions.
#pragma once

#include <span>
#include <vector>

#include "model/edge_table.h"

namespace gabarit {

struct EdgeOverlap {
  HalfEdgeId edge;   // the one asked about
  HalfEdgeId other;  // of another facet
  bool reversed;     // the other runs the opposite way
  float from, to;    // the shared segment, as fractions of the edge asked about
};

// For each of the `asked` half-edges (open ones: those without an exact partner) the other half-edges of the
// mesh that lie within `tolerance` (mm) of its line and overlap it by more than that, and that have no exact
// partner of their own.
std::vector<EdgeOverlap> overlapping_edges(const TriangleMesh& mesh, std::span<const HalfEdgeId> asked,
                                           double tolerance);

}  // namespace gabarit
