#include "model/edge_table.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace gabarit {

static VertexId start(const TriangleMesh& mesh, HalfEdgeId h) { return mesh.facets[h / 3][h % 3]; }

bool run_opposite(const TriangleMesh& mesh, HalfEdgeId a, HalfEdgeId b) {
  return start(mesh, a) != start(mesh, b);
}

// A counting sort by the lower end leaves buckets of a few half-edges, which are then sorted in place.
EdgeTable::EdgeTable(const TriangleMesh& mesh, const std::vector<bool>* vertices) : mesh_(&mesh) {
  if (mesh.facet_count() > std::numeric_limits<HalfEdgeId>::max() / 3)
    throw std::length_error("the model has too many facets");
  std::vector<HalfEdgeId> first(mesh.vertices.size() + 1, 0);
  std::vector<bool> usable(mesh.facet_count());
  const auto wanted = [&](VertexId v) { return vertices == nullptr || (*vertices)[v]; };
  const auto for_each_half_edge = [&](auto&& visit) {
    for (FacetId f = 0; f < mesh.facet_count(); ++f) {
      if (!usable[f]) continue;
      for (HalfEdgeId e = 0; e < 3; ++e) {
        const auto [low, high] = ends(3 * f + e);
        if (wanted(low) && wanted(high)) visit(low, 3 * f + e);
      }
    }
  };
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const auto& [a, b, c] = mesh.facets[f];
    const int ends_wanted = wanted(a) + wanted(b) + wanted(c);
    usable[f] = ends_wanted >= 2 && facet_normal(mesh, f) != Vec3d{};
  }
  for_each_half_edge([&](VertexId low, HalfEdgeId) { ++first[low + 1]; });
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  half_edges_.resize(first.back());
  std::vector<HalfEdgeId> next(first.begin(), first.end() - 1);
  for_each_half_edge([&](VertexId low, HalfEdgeId h) { half_edges_[next[low]++] = h; });
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    std::sort(half_edges_.begin() + first[v], half_edges_.begin() + first[v + 1],
              [this](HalfEdgeId a, HalfEdgeId b) {
                const VertexId high_a = ends(a).second;
                const VertexId high_b = ends(b).second;
                return high_a != high_b ? high_a < high_b : a < b;
              });
  }
}

}  // namespace gabarit
