#include "model/adjacency.h"

#include <algorithm>
#include <tuple>

#include "gpu/parallel_for.h"
#include "model/edge_overlap.h"
#include "model/edge_table.h"

namespace gabarit {
namespace {

struct Pair {
  HalfEdgeId edge;
  EdgeNeighbour neighbour;
};

// Flags the vertices of the facets asked about; every edge between two of them is looked at.
std::vector<bool> vertices_of(const TriangleMesh& mesh, std::span<const FacetId> facets) {
  std::vector<bool> flags(mesh.vertices.size());
  for (const FacetId f : facets) {
    for (const VertexId v : mesh.facets[f]) flags[v] = true;
  }
  return flags;
}

EdgeNeighbour exact_neighbour(const TriangleMesh& mesh, HalfEdgeId asked, HalfEdgeId other) {
  return {.facet = other / 3,
          .edge = static_cast<std::uint8_t>(asked % 3),
          .other = static_cast<std::uint8_t>(other % 3),
          .reversed = run_opposite(mesh, asked, other)};
}

}  // namespace

Adjacency::Adjacency(const TriangleMesh& mesh, std::span<const FacetId> of, double tolerance,
                     const Device& device) {
  row_.assign(mesh.facet_count(), 0);
  if (of.empty()) {
    for (FacetId f = 0; f < mesh.facet_count(); ++f) row_[f] = f + 1;
  } else {
    std::uint32_t rows = 0;
    for (const FacetId f : of) {
      if (row_[f] == 0) row_[f] = ++rows;
    }
  }
  std::vector<bool> flags;
  if (!of.empty()) flags = vertices_of(mesh, of);

  std::vector<Pair> pairs;
  std::vector<HalfEdgeId> open;
  EdgeTable(mesh, of.empty() ? nullptr : &flags).for_each_edge([&](std::span<const HalfEdgeId> edge) {
    for (const HalfEdgeId asked : edge) {
      if (row_[asked / 3] == 0) continue;
      if (edge.size() == 1) open.push_back(asked);
      for (const HalfEdgeId other : edge) {
        if (other / 3 != asked / 3) pairs.push_back({asked, exact_neighbour(mesh, asked, other)});
      }
    }
  });
  for (const EdgeOverlap& overlap : overlapping_edges(mesh, open, tolerance)) {
    pairs.push_back({overlap.edge,
                     {.facet = overlap.other / 3,
                      .edge = static_cast<std::uint8_t>(overlap.edge % 3),
                      .other = static_cast<std::uint8_t>(overlap.other % 3),
                      .reversed = overlap.reversed,
                      .from = overlap.from,
                      .to = overlap.to}});
  }

  const std::size_t rows = of.empty() ? mesh.facet_count() : *std::max_element(row_.begin(), row_.end());
  first_.assign(rows + 1, 0);
  for (const Pair& pair : pairs) ++first_[row_[pair.edge / 3]];
  for (std::size_t r = 1; r < first_.size(); ++r) first_[r] += first_[r - 1];
  neighbours_.resize(pairs.size());
  std::vector<std::uint64_t> next(first_.begin(), first_.end() - 1);
  for (const Pair& pair : pairs) neighbours_[next[row_[pair.edge / 3] - 1]++] = pair.neighbour;
  const auto sort_row = [&](std::int64_t r) {
    const auto row = static_cast<std::size_t>(r);
    std::sort(neighbours_.begin() + static_cast<std::ptrdiff_t>(first_[row]),
              neighbours_.begin() + static_cast<std::ptrdiff_t>(first_[row + 1]),
              [](const EdgeNeighbour& a, const EdgeNeighbour& b) {
                return std::tie(a.edge, a.facet, a.other, a.from) <
                       std::tie(b.edge, b.facet, b.other, b.from);
              });
  };
  parallel_for_cpu(device, static_cast<std::int64_t>(rows), sort_row, 8192);
}

std::span<const EdgeNeighbour> Adjacency::of(FacetId facet) const {
  const std::uint32_t row = row_[facet];
  if (row == 0) return {};
  return std::span(neighbours_).subspan(first_[row - 1], first_[row] - first_[row - 1]);
}

}  // namespace gabarit
