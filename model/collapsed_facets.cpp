#include "model/collapsed_facets.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace gabarit {
namespace {

constexpr double collapsed_height = 1e-6;  // mm

// Twice the area over the longest side, and which side that is.
struct Height {
  double value;
  std::size_t longest;
};

Height height(const TriangleMesh& mesh, const std::array<VertexId, 3>& facet) {
  std::array<double, 3> sides{};
  for (std::size_t i = 0; i < 3; ++i)
    sides[i] = length(mesh.vertices[facet[(i + 1) % 3]] - mesh.vertices[facet[i]]);
  const auto longest = static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
  const Vec3d a = mesh.vertices[facet[0]];
  const double twice = length(cross(mesh.vertices[facet[1]] - a, mesh.vertices[facet[2]] - a));
  return {sides[longest] > 0 ? twice / sides[longest] : 0, longest};
}

class Flipping {
 public:
  Flipping(TriangleMesh& mesh, std::vector<FacetOrigin>& origins, FacetId first, FacetId last)
      : mesh_(&mesh), origins_(&origins) {
    for (FacetId f = first; f < last; ++f) enter(f);
  }

  bool flip(FacetId f) {
    const auto [low, side] = height(*mesh_, mesh_->facets[f]);
    const std::array<VertexId, 3> own = mesh_->facets[f];
    const VertexId a = own[side], b = own[(side + 1) % 3], m = own[(side + 2) % 3];
    const auto found = facet_of_.find(key(b, a));
    if (found == facet_of_.end() || found->second == f) return false;
    const FacetId other = found->second;
    if ((*origins_)[other].face != (*origins_)[f].face) return false;
    const std::array<VertexId, 3> theirs = mesh_->facets[other];
    const auto at_b = static_cast<std::size_t>(std::find(theirs.begin(), theirs.end(), b) - theirs.begin());
    const VertexId c = theirs[(at_b + 2) % 3];
    const std::array<VertexId, 3> one{m, a, c}, two{m, c, b};
    if (c == m || facet_of_.contains(key(m, c)) || facet_of_.contains(key(c, m))) return false;
    if (std::min(height(*mesh_, one).value, height(*mesh_, two).value) <= low) return false;
    const auto& p = (*origins_)[f].corners;
    const auto& q = (*origins_)[other].corners;
    const Parameters at_m = p[(side + 2) % 3], at_c = q[(at_b + 2) % 3], at_a = p[side],
                     at_b_uv = p[(side + 1) % 3];
    leave(f), leave(other);
    mesh_->facets[f] = one, mesh_->facets[other] = two;
    (*origins_)[f].corners = {at_m, at_a, at_c};
    (*origins_)[other].corners = {at_m, at_c, at_b_uv};
    enter(f), enter(other);
    return true;
  }

 private:
  static std::uint64_t key(VertexId a, VertexId b) { return std::uint64_t{a} << 32U | b; }
  void enter(FacetId f) {
    const auto& v = mesh_->facets[f];
    for (std::size_t i = 0; i < 3; ++i) facet_of_.insert({key(v[i], v[(i + 1) % 3]), f});
  }
  void leave(FacetId f) {
    const auto& v = mesh_->facets[f];
    for (std::size_t i = 0; i < 3; ++i) facet_of_.erase(key(v[i], v[(i + 1) % 3]));
  }

  TriangleMesh* mesh_;
  std::vector<FacetOrigin>* origins_;
  std::unordered_map<std::uint64_t, FacetId> facet_of_;  // by directed edge
};

}  // namespace

std::uint64_t flip_collapsed_facets(TriangleMesh& mesh, std::vector<FacetOrigin>& origins, FacetId first,
                                    FacetId last) {
  std::vector<FacetId> collapsed;
  for (FacetId f = first; f < last; ++f) {
    if (height(mesh, mesh.facets[f]).value < collapsed_height) collapsed.push_back(f);
  }
  if (collapsed.empty()) return 0;
  Flipping flipping(mesh, origins, first, last);
  std::uint64_t flipped = 0;
  // Collapsed facets lie in fans: one that is in the way of another may go first.
  for (bool any = true; any;) {
    any = false;
    for (const FacetId f : collapsed) {
      if (height(mesh, mesh.facets[f]).value >= collapsed_height || !flipping.flip(f)) continue;
      ++flipped;
      any = true;
    }
  }
  return flipped;
}

}  // namespace gabarit
