#include "checks/slivers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gabarit {

namespace {

constexpr int most_slivers_in_a_row = 8;

double longest_side(const TriangleMesh& mesh, FacetId f) {
  const auto [a, b, c] = mesh.corners(f);
  return std::max({length(b - a), length(c - b), length(a - c)});
}

double side(const TriangleMesh& mesh, FacetId f, int edge) {
  return length(mesh.corner(f, (edge + 1) % 3) - mesh.corner(f, edge));
}

class Bridge {
 public:
  Bridge(const TriangleMesh& mesh, const Adjacency& adjacency, FacetId from, std::vector<EdgeNeighbour>& out)
      : mesh_(&mesh), adjacency_(&adjacency), out_(&out), from_(from) {}

  // `n` is a neighbour of the facet it started from, behind `count` slivers.
  void cross(const EdgeNeighbour& n, int count) {
    if (!is_sliver(*mesh_, n.facet)) return out_->push_back(n);
    if (count == most_slivers_in_a_row) return;
    passed_[static_cast<std::size_t>(count)] = n.facet;
    const double shortest = 0.25 * longest_side(*mesh_, n.facet);
    for (const EdgeNeighbour& next : adjacency_->of(n.facet)) {
      if (next.edge == n.other || side(*mesh_, n.facet, next.edge) < shortest ||
          has_passed(next.facet, count))
        continue;
      // Both steps keep the sense of rotation, or both turn it round.
      cross(
          {.facet = next.facet, .edge = n.edge, .other = next.other, .reversed = n.reversed == next.reversed},
          count + 1);
    }
  }

 private:
  bool has_passed(FacetId f, int count) const {
    return f == from_ ||
           std::find(passed_.begin(), passed_.begin() + count + 1, f) != passed_.begin() + count + 1;
  }

  const TriangleMesh* mesh_;
  const Adjacency* adjacency_;
  std::vector<EdgeNeighbour>* out_;
  FacetId from_;
  std::array<FacetId, most_slivers_in_a_row> passed_{};
};

}  // namespace

double coordinate_rounding(const Vec3d& p) {
  return std::ldexp(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}), -24);
}

bool is_sliver(const TriangleMesh& mesh, FacetId f) {
  const auto [a, b, c] = mesh.corners(f);
  const double twice_area = length(cross(b - a, c - a));
  const double rounding = std::max({coordinate_rounding(a), coordinate_rounding(b), coordinate_rounding(c)});
  return 2 * rounding * longest_side(mesh, f) > 0.02 * twice_area;
}

void neighbours_over_slivers(const TriangleMesh& mesh, const Adjacency& adjacency, FacetId f,
                             std::vector<EdgeNeighbour>& out) {
  Bridge bridge(mesh, adjacency, f, out);
  for (const EdgeNeighbour& n : adjacency.of(f)) bridge.cross(n, 0);
}

}  // namespace gabarit
