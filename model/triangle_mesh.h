// The facets of a model in input order, over welded vertices. Millimetres.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gpu/box.h"
#include "gpu/vec3.h"

namespace gabarit {

using FacetId = std::uint32_t;
using VertexId = std::uint32_t;
// Half-edges, three a facet, are numbered by 32 bits; loaders refuse more.
inline constexpr std::uint64_t most_facets = 0xFFFFFFFFU / 3;

struct TriangleMesh {
  // Equal coordinates (bit for bit, -0 = 0) are one vertex; facets made of exact surfaces share vertices
  // where the faces of their body share an edge, and nowhere else.
  std::vector<Vec3d> vertices;
  std::vector<std::array<VertexId, 3>> facets;  // as in the file: none dropped, merged or re-ordered
  std::vector<std::uint32_t> body;  // which body each facet belongs to; empty: all belong to body 0

  std::size_t facet_count() const { return facets.size(); }
  const Vec3d& corner(FacetId f, int i) const { return vertices[facets[f][static_cast<std::size_t>(i)]]; }
  std::array<Vec3d, 3> corners(FacetId f) const { return {corner(f, 0), corner(f, 1), corner(f, 2)}; }
  Vec3d centroid(FacetId f) const { return (corner(f, 0) + corner(f, 1) + corner(f, 2)) / 3.0; }
  std::uint32_t body_of(FacetId f) const { return body.empty() ? 0 : body[f]; }
};

// Outward unit normal by the right-hand rule; zero when the facet is degenerate (its cross product is
// rounding noise: |N|² <= 1e-20 |e1|² |e2|²) or not finite.
Vec3d facet_normal(const TriangleMesh& mesh, FacetId f);
// mm²; 0 for facets that are not finite.
double facet_area(const TriangleMesh& mesh, FacetId f);
// Of the finite vertices that a facet uses.
Box3d bounding_box(const TriangleMesh& mesh);

}  // namespace gabarit
