#include "checks/folds.h"

#include <algorithm>
#include <cmath>

#include "checks/orientation.h"
#include "checks/slivers.h"
#include "checks/surroundings.h"
#include "gpu/parallel_for.h"

namespace gabarit {

namespace {

constexpr std::int64_t grain = 2048;

double rounding(const FacetEdge& e) {
  return std::max({coordinate_rounding(e.from), coordinate_rounding(e.to), coordinate_rounding(e.apex)});
}

Fold fold(const TriangleMesh& mesh, FacetId f, const EdgeNeighbour& n) {
  const FacetEdge here = facet_edge(mesh, f, n.edge);
  const FacetEdge there = facet_edge(mesh, n.facet, n.other);
  const Vec3d along = (here.to - here.from) / here.length;
  const Vec3d normal = facet_normal(mesh, f);
  const Vec3d other = n.reversed ? facet_normal(mesh, n.facet) : -facet_normal(mesh, n.facet);
  const double turn = std::atan2(dot(cross(normal, other), along), dot(normal, other));
  // A corner of either facet can be off by the rounding, in any direction.
  const double noise = 2 * rounding(here) * (1 / here.height + 1 / there.height);
  return {.facet = n.facet,
          .edge = n.edge,
          .other = n.other,
          .oriented = n.reversed,
          .convex = turn > noise + smallest_turn,
          .turn = static_cast<float>(turn),
          .noise = static_cast<float>(std::min(noise, 4.0))};
}

double distance_to_line(const Vec3d& p, const FacetEdge& e) {
  return length(cross(p - e.from, e.to - e.from)) / e.length;
}

// Whether the first of two facets beside an edge can be curved like the other: over its height the least
// curvature that explains the turn must not leave it by more than the sag, with room for irregular facets.
bool can_curve(double turn, double height, double other, double sag) {
  const double least_curvature = turn / (0.5 * (height + other));
  return least_curvature * height * height / 8 < 1.2 * sag;
}

}  // namespace

FacetEdge facet_edge(const TriangleMesh& mesh, FacetId f, int edge) {
  FacetEdge e{.from = mesh.corner(f, edge),
              .to = mesh.corner(f, (edge + 1) % 3),
              .apex = mesh.corner(f, (edge + 2) % 3)};
  const Vec3d d = e.to - e.from;
  e.length = length(d);
  e.foot = dot(e.apex - e.from, d) / e.length;
  e.height = length(cross(e.apex - e.from, d)) / e.length;
  return e;
}

Folds::Folds(const Scene& scene, std::span<const FacetId> facets, int rings, double sag) {
  Surroundings around = surroundings(scene, facets, rings);
  facets_ = std::move(around.facets);
  row_.assign(scene.mesh().facet_count(), 0);
  inside_out_ = inside_out_bodies(scene.mesh(), scene.device());
  fill(scene, *around.adjacency);
  find_rims(scene, sag);
}

void Folds::fill(const Scene& scene, const Adjacency& adjacency) {
  const TriangleMesh& mesh = scene.mesh();
  const auto count = static_cast<std::int64_t>(facets_.size());
  first_.assign(facets_.size() + 1, 0);
  for (std::size_t i = 0; i < facets_.size(); ++i) row_[facets_[i]] = static_cast<std::uint32_t>(i + 1);
  const auto count_them = [&](std::int64_t i) {
    std::vector<EdgeNeighbour> neighbours;
    neighbours_over_slivers(mesh, adjacency, facets_[static_cast<std::size_t>(i)], neighbours);
    first_[static_cast<std::size_t>(i) + 1] = neighbours.size();
  };
  parallel_for_cpu(scene.device(), count, count_them, grain);
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  folds_.resize(first_.back());
  const auto looks_inwards = [&](std::uint32_t body) {
    return std::binary_search(inside_out_.begin(), inside_out_.end(), body);
  };
  const auto fill_them = [&](std::int64_t i) {
    const FacetId f = facets_[static_cast<std::size_t>(i)];
    std::vector<EdgeNeighbour> neighbours;
    neighbours_over_slivers(mesh, adjacency, f, neighbours);
    std::uint64_t at = first_[static_cast<std::size_t>(i)];
    for (const EdgeNeighbour& n : neighbours) {
      folds_[at] = fold(mesh, f, n);
      if (looks_inwards(mesh.body_of(f))) folds_[at].oriented = false;
      ++at;
    }
  };
  parallel_for_cpu(scene.device(), count, fill_them, grain);
}

// Whether there is convex turning on the far side of facet f as seen from one of its edges, no further away
// than a few times the facet's height: at its other edges, or, since most strips are quadrilaterals cut in
// two, at the far edges of what lies behind those.
bool Folds::turns_beyond(const TriangleMesh& mesh, FacetId f, int edge) const {
  const FacetEdge e = facet_edge(mesh, f, edge);
  for (const Fold& next : of(f)) {
    if (next.edge == edge) continue;
    if (next.convex) return true;
    for (const Fold& far : of(next.facet)) {
      if (!far.convex || far.edge == next.other) continue;
      const Vec3d middle =
          0.5 * (mesh.corner(next.facet, far.edge) + mesh.corner(next.facet, (far.edge + 1) % 3));
      const double distance = distance_to_line(middle, e);
      if (distance > 0.5 * e.height && distance < 2.5 * e.height) return true;
    }
  }
  return false;
}

void Folds::find_rims(const Scene& scene, double sag) {
  const TriangleMesh& mesh = scene.mesh();
  const auto kernel = [&](std::int64_t i) {
    const auto row = static_cast<std::size_t>(i);
    for (std::uint64_t at = first_[row]; at < first_[row + 1]; ++at) {
      Fold& one = folds_[at];
      if (!one.convex) continue;
      const double here = facet_edge(mesh, facets_[row], one.edge).height;
      const double there = facet_edge(mesh, one.facet, one.other).height;
      one.turns_here = can_curve(one.turn, here, there, sag) && turns_beyond(mesh, facets_[row], one.edge);
      one.turns_there = can_curve(one.turn, there, here, sag) && turns_beyond(mesh, one.facet, one.other);
    }
  };
  parallel_for_cpu(scene.device(), static_cast<std::int64_t>(facets_.size()), kernel, grain);
}

std::vector<FacetId> Folds::within(std::span<const FacetId> facets, int rings) const {
  std::vector<FacetId> found(facets.begin(), facets.end());
  std::vector<bool> seen(row_.size());
  for (const FacetId f : facets) seen[f] = true;
  std::size_t begin = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t end = found.size();
    for (; begin < end; ++begin) {
      for (const Fold& n : of(found[begin])) {
        if (!seen[n.facet]) seen[n.facet] = true, found.push_back(n.facet);
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace gabarit
