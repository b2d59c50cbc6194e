#include "checks/contact_features.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace gabarit {
namespace {

const double least_bend = 8 * std::numbers::pi / 180;

Vec3f to_float(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// A segment of an edge between two facets, in the direction in which the first one has it.
struct Ridge {
  Vec3d a, b;
  VertexId from, to;  // its ends, where they are vertices
  FacetId one, other;
};

constexpr VertexId no_vertex = 0xffffffffU;
constexpr std::size_t most_directions = 64;  // of a vertex that are worth comparing with each other

class Features {
 public:
  Features(FacetSurface& surface, const TriangleMesh& mesh, std::span<const Vec3d> normals,
           const std::vector<float>& sag, Side side)
      : surface_(surface),
        mesh_(mesh),
        normals_(normals),
        sag_(sag),
        side_(side),
        id_(static_cast<std::uint32_t>(mesh.facet_count())) {}

  void look_at(FacetId f, const EdgeNeighbour& edge) {
    if (f > edge.facet || !edge.reversed) return;
    const Vec3d n = normals_[f], m = normals_[edge.facet];
    const Vec3d a = mesh_.corner(f, edge.edge), along = mesh_.corner(f, (edge.edge + 1) % 3) - a;
    // Seen along the edge the normals of a reflex edge turn towards each other.
    const double turn = dot(cross(n, m), along) * (side_ == Side::inside ? -1 : 1);
    if (!(turn > 0) || dot(n, m) > std::cos(least_bend)) return;
    const auto end = [&](double at, int corner) {
      return at == corner ? mesh_.facets[f][static_cast<std::size_t>((edge.edge + corner) % 3)] : no_vertex;
    };
    const double from = edge.from, to = edge.to;
    add({a + from * along, to == 1 ? a + along : a + to * along, end(from, 0), end(to, 1), f, edge.facet});
  }

  // Every direction in which the surface leaves the vertices at the ends of ridges.
  void add_vertices() {
    std::map<VertexId, Star> stars;
    std::vector<bool> is_end(mesh_.vertices.size());
    for (const VertexId v : ends_) stars[v], is_end[v] = true;
    for (FacetId f = 0; f < mesh_.facet_count(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (!is_end[mesh_.facets[f][i]]) continue;
        Star& star = stars.at(mesh_.facets[f][i]);
        const Vec3d normal = normals_[f];
        if (normal != Vec3d{}) star.normals.push_back(normal);
        for (const std::size_t k : {(i + 1) % 3, (i + 2) % 3}) {
          const Vec3d w = normalized(mesh_.vertices[mesh_.facets[f][k]] - mesh_.vertices[mesh_.facets[f][i]]);
          if (is_finite(w) && w != Vec3d{}) star.directions.push_back(w);
        }
      }
    }
    for (auto& [v, star] : stars) {
      add_sums(star.directions);
      add_outward(star.normals, star.directions);
      push({v, v, fan(star.directions)}, sags_.at(v));
    }
  }

 private:
  struct Star {
    std::vector<Vec3d> normals, directions;
  };

  // A ball reaches the feature from the side that the facets around it face away from. Where these agree,
  // that direction stands in the fan too: it tells at a glance that the feature cannot stop a ball on its own
  // wall.
  void add_outward(const std::vector<Vec3d>& normals, std::vector<Vec3d>& directions) const {
    Vec3d sum;
    for (const Vec3d& n : normals) sum += n;
    const Vec3d mean = normalized(sum);
    for (const Vec3d& n : normals)
      if (dot(n, mean) < 0.5) return;
    if (mean != Vec3d{}) directions.push_back(side_ == Side::inside ? mean : -mean);
  }

  // What is on the positive side of two directions is on that of their sum: of two that are almost opposite
  // it tells the same.
  static void add_sums(std::vector<Vec3d>& directions) {
    const std::size_t count = directions.size();
    if (count > most_directions) return;
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t opposite = i;
      for (std::size_t j = 0; j < count; ++j)
        if (dot(directions[i], directions[j]) < dot(directions[i], directions[opposite])) opposite = j;
      const Vec3d sum = directions[i] + directions[opposite];
      if (length(sum) > 0.1 && length(sum) < 1) directions.push_back(normalized(sum));
    }
  }

  void add(const Ridge& ridge) {
    const Vec3d along = normalized(ridge.b - ridge.a);
    const float s = std::max(sag_[ridge.one], sag_[ridge.other]);
    const std::uint32_t number =
        fan({normalized(cross(normals_[ridge.one], along)), normalized(cross(along, normals_[ridge.other]))});
    push({point(ridge.from, ridge.a), point(ridge.to, ridge.b), number}, s);
    for (const VertexId v : {ridge.from, ridge.to}) {
      if (v == no_vertex) continue;
      ends_.push_back(v);
      float& most = sags_[v];
      most = std::max(most, s);
    }
  }

  void push(const std::array<std::uint32_t, 3>& corner, float sag) {
    surface_.primitives.push_back({corner, id_++, {}, sag});
  }

  std::uint32_t point(VertexId v, const Vec3d& p) {
    if (v != no_vertex) return v;
    surface_.points.push_back(p);
    return static_cast<std::uint32_t>(surface_.points.size() - 1);
  }

  std::uint32_t fan(const std::vector<Vec3d>& directions) {
    for (const Vec3d& w : directions) surface_.fan_directions.push_back(to_float(w));
    surface_.fan_first.push_back(static_cast<std::uint32_t>(surface_.fan_directions.size()));
    return static_cast<std::uint32_t>(surface_.fan_first.size() - 2);
  }

  FacetSurface& surface_;
  const TriangleMesh& mesh_;
  std::span<const Vec3d> normals_;
  const std::vector<float>& sag_;
  Side side_;
  std::uint32_t id_;
  std::vector<VertexId> ends_;
  std::map<VertexId, float> sags_;
};

}  // namespace

void add_features(FacetSurface& surface, const TriangleMesh& mesh, std::span<const Vec3d> normals,
                  const Adjacency& adjacency, const std::vector<float>& sag, Side side) {
  Features features(surface, mesh, normals, sag, side);
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    for (const EdgeNeighbour& edge : adjacency.of(f)) features.look_at(f, edge);
  }
  features.add_vertices();
}

}  // namespace gabarit
