#include "model/defects.h"

#include <algorithm>

#include "model/edge_table.h"

namespace gabarit {

static bool finite(const TriangleMesh& mesh, FacetId f) {
  return is_finite(mesh.corner(f, 0)) && is_finite(mesh.corner(f, 1)) && is_finite(mesh.corner(f, 2));
}

// Facets over the same three vertices all lie on the edge between their two lowest ones.
static std::uint64_t duplicates_on(const TriangleMesh& mesh, std::span<const HalfEdgeId> edge) {
  if (edge.size() < 2) return 0;
  const auto opposite_of = [&](HalfEdgeId h) { return mesh.facets[h / 3][(h % 3 + 2) % 3]; };
  if (edge.size() == 2) {
    const auto& corners = mesh.facets[edge[0] / 3];
    const VertexId opposite = opposite_of(edge[0]);
    return opposite == opposite_of(edge[1]) && opposite == *std::max_element(corners.begin(), corners.end());
  }
  std::vector<VertexId> third;
  for (const HalfEdgeId h : edge) {
    const auto& corners = mesh.facets[h / 3];
    const VertexId opposite = opposite_of(h);
    if (opposite == *std::max_element(corners.begin(), corners.end())) third.push_back(opposite);
  }
  std::sort(third.begin(), third.end());
  const auto distinct = std::unique(third.begin(), third.end());
  return static_cast<std::uint64_t>(third.end() - distinct);
}

Defects count_defects(const TriangleMesh& mesh) {
  Defects defects;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    if (!finite(mesh, f)) {
      ++defects.not_finite;
    } else if (facet_normal(mesh, f) == Vec3d{}) {
      ++defects.degenerate;
    }
  }
  EdgeTable(mesh).for_each_edge([&](std::span<const HalfEdgeId> edge) {
    defects.open_edges += edge.size() == 1;
    defects.non_manifold_edges += edge.size() > 2;
    defects.misoriented_edges += edge.size() == 2 && !run_opposite(mesh, edge[0], edge[1]);
    defects.duplicate += duplicates_on(mesh, edge);
  });
  return defects;
}

}  // namespace gabarit
