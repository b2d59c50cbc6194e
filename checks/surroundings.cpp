#include "checks/surroundings.h"

#include <cstdint>

#include "gpu/parallel_for.h"

namespace gabarit {

namespace {

using Flags = std::vector<std::uint8_t>;

std::vector<FacetId> flagged(const Flags& flags) {
  std::vector<FacetId> facets;
  for (FacetId f = 0; f < flags.size(); ++f) {
    if (flags[f] != 0) facets.push_back(f);
  }
  return facets;
}

// The whole mesh's adjacency is worth building when a good part of the mesh is asked about.
bool is_large(std::size_t asked, const TriangleMesh& mesh) { return asked > mesh.facet_count() / 8; }

// Flags the facets that share a vertex with those flagged, so many times.
void add_rings(const Scene& scene, int rings, Flags& facets) {
  const TriangleMesh& mesh = scene.mesh();
  Flags vertices(mesh.vertices.size());
  for (int ring = 0; ring < rings; ++ring) {
    for (FacetId f = 0; f < mesh.facet_count(); ++f) {
      if (facets[f] == 0) continue;
      for (const VertexId v : mesh.facets[f]) vertices[v] = 1;
    }
    const auto kernel = [&](std::int64_t i) {
      const auto f = static_cast<std::size_t>(i);
      const auto& [a, b, c] = mesh.facets[f];
      facets[f] = static_cast<std::uint8_t>(facets[f] | vertices[a] | vertices[b] | vertices[c]);
    };
    parallel_for_cpu(scene.device(), static_cast<std::int64_t>(mesh.facet_count()), kernel, 1 << 16);
  }
}

// Flags what lies within the rings and is not flagged yet; says whether there was any.
bool add_missing(const Adjacency& adjacency, std::span<const FacetId> facets, int rings, Flags& near) {
  Flags seen(near.size());
  std::vector<FacetId> last(facets.begin(), facets.end());
  for (const FacetId f : last) seen[f] = 1;
  bool missing = false;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<FacetId> next;
    for (const FacetId f : last) {
      for (const EdgeNeighbour& n : adjacency.of(f)) {
        if (seen[n.facet] != 0) continue;
        seen[n.facet] = 1;
        next.push_back(n.facet);
        missing = missing || near[n.facet] == 0;
        near[n.facet] = 1;
      }
    }
    last = std::move(next);
  }
  return missing;
}

}  // namespace

Surroundings surroundings(const Scene& scene, std::span<const FacetId> facets, int rings) {
  const TriangleMesh& mesh = scene.mesh();
  if (is_large(facets.size(), mesh)) {
    return {flagged(Flags(mesh.facet_count(), 1)), {&scene.adjacency(), [](const Adjacency*) {}}};
  }
  Flags near(mesh.facet_count());
  for (const FacetId f : facets) near[f] = 1;
  add_rings(scene, (rings + 1) / 2, near);  // two steps over edges stay within one ring of vertices
  // Beyond a T-junction lie neighbours that have no vertex in common.
  Surroundings found;
  do {
    found.facets = flagged(near);
    found.adjacency = std::make_shared<Adjacency>(mesh, found.facets);
  } while (add_missing(*found.adjacency, facets, rings, near));
  return found;
}

}  // namespace gabarit
