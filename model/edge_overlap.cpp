#include "model/edge_overlap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace gabarit {
namespace {

struct Segment {
  Vec3d from, to;
};

Segment segment(const TriangleMesh& mesh, HalfEdgeId h) {
  return {mesh.corner(h / 3, static_cast<int>(h % 3)),
          mesh.corner(h / 3, static_cast<int>((h + 1) % 3 == 0 ? 0 : h % 3 + 1))};
}

// A hashed grid of cubes over the asked edges; an edge is entered in every cube that its samples, half a cube
// apart, fall in.
class EdgeGrid {
 public:
  EdgeGrid(const TriangleMesh& mesh, std::span<const HalfEdgeId> edges, double tolerance)
      : tolerance_(tolerance) {
    double sum = 0;
    for (const HalfEdgeId h : edges) {
      const Segment s = segment(mesh, h);
      box_.add(s.from);
      box_.add(s.to);
      sum += length(s.to - s.from);
    }
    box_.min = box_.min - Vec3d{tolerance, tolerance, tolerance};
    box_.max = box_.max + Vec3d{tolerance, tolerance, tolerance};
    const Vec3d e = box_.extent();
    // Cubes as long as the mean edge, and no more than a million along a side.
    size_ =
        std::max({sum / static_cast<double>(edges.size()), 4 * tolerance, std::max({e.x, e.y, e.z}) / 1e6});
    for (const HalfEdgeId h : edges) {
      for_each_cube(segment(mesh, h), [&](std::uint64_t cube) { cubes_[cube].push_back(h); });
    }
  }

  bool near(const Segment& s) const {
    const Vec3d low = min(s.from, s.to);
    const Vec3d high = max(s.from, s.to);
    return low.x <= box_.max.x && low.y <= box_.max.y && low.z <= box_.max.z && high.x >= box_.min.x &&
           high.y >= box_.min.y && high.z >= box_.min.z;
  }

  void candidates(const Segment& s, std::vector<HalfEdgeId>& out) const {
    out.clear();
    for_each_cube(s, [&](std::uint64_t cube) {
      if (const auto found = cubes_.find(cube); found != cubes_.end())
        out.insert(out.end(), found->second.begin(), found->second.end());
    });
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
  }

 private:
  // The part of a segment inside the grid's box, so that no edge takes more steps than the grid has cubes;
  // none when it passes by.
  std::optional<Segment> inside(const Segment& s) const {
    double from = 0;
    double to = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const double d = s.to[axis] - s.from[axis];
      const double low = (box_.min[axis] - s.from[axis]) / d;
      const double high = (box_.max[axis] - s.from[axis]) / d;
      if (d == 0) {
        if (s.from[axis] < box_.min[axis] || s.from[axis] > box_.max[axis]) return std::nullopt;
      } else {
        from = std::max(from, std::min(low, high));
        to = std::min(to, std::max(low, high));
      }
    }
    if (from > to) return std::nullopt;
    const Vec3d along = s.to - s.from;
    return Segment{s.from + along * from, s.from + along * to};
  }

  // Every cube within the tolerance of the segment: the cubes around each of its samples' corners.
  template <class Visit>
  void for_each_cube(const Segment& whole, Visit&& visit) const {
    const std::optional<Segment> part = inside(whole);
    if (!part) return;
    const Segment& s = *part;
    const double l = length(s.to - s.from);
    const auto steps = static_cast<std::int64_t>(std::ceil(2 * l / size_));
    const double reach = tolerance_ + 0.25 * size_;
    for (std::int64_t i = 0; i <= steps; ++i) {
      const Vec3d p =
          s.from + (s.to - s.from) * (steps == 0 ? 0.0 : static_cast<double>(i) / static_cast<double>(steps));
      const auto cell = [&](double x, double low) {
        return static_cast<std::int64_t>(std::floor((x - low) / size_));
      };
      for (auto x = cell(p.x - reach, box_.min.x); x <= cell(p.x + reach, box_.min.x); ++x)
        for (auto y = cell(p.y - reach, box_.min.y); y <= cell(p.y + reach, box_.min.y); ++y)
          for (auto z = cell(p.z - reach, box_.min.z); z <= cell(p.z + reach, box_.min.z); ++z)
            visit(key(x, y, z));
    }
  }

  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    constexpr std::int64_t offset = 1 << 4;
    constexpr std::uint64_t mask = (1U << 21U) - 1;
    return ((static_cast<std::uint64_t>(x + offset) & mask) << 42U) |
           ((static_cast<std::uint64_t>(y + offset) & mask) << 21U) |
           (static_cast<std::uint64_t>(z + offset) & mask);
  }

  double tolerance_, size_ = 1;
  Box3d box_;
  std::unordered_map<std::uint64_t, std::vector<HalfEdgeId>> cubes_;
};

// Distance of both ends of `other` from the line of `s`, and the shared part along it.
bool overlap(const Segment& s, const Segment& other, double tolerance, EdgeOverlap& out) {
  const Vec3d along = s.to - s.from;
  const double l = length(along);
  if (l <= tolerance) return false;
  const Vec3d u = along / l;
  const double a = dot(other.from - s.from, u);
  const double b = dot(other.to - s.from, u);
  const double begin = std::max(0.0, std::min(a, b));
  const double end = std::min(l, std::max(a, b));
  if (end - begin <= tolerance) return false;
  // Only the shared part has to lie on the line: its ends, found on the other edge.
  const auto off_line = [&](double at) {
    const double t = (at - a) / (b - a);
    return length(other.from + (other.to - other.from) * t - (s.from + u * at));
  };
  if (off_line(begin) > tolerance || off_line(end) > tolerance) return false;
  out.from = static_cast<float>(begin / l);
  out.to = static_cast<float>(end / l);
  out.reversed = b < a;
  return true;
}

}  // namespace

std::vector<EdgeOverlap> overlapping_edges(const TriangleMesh& mesh, std::span<const HalfEdgeId> asked,
                                           double tolerance) {
  std::vector<EdgeOverlap> found;
  if (asked.empty()) return found;
  const EdgeGrid grid(mesh, asked, tolerance);
  std::vector<HalfEdgeId> near;
  std::vector<bool> vertices(mesh.vertices.size());
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    if (facet_normal(mesh, f) == Vec3d{}) continue;
    for (HalfEdgeId h = 3 * f; h < 3 * f + 3; ++h) {
      const Segment other = segment(mesh, h);
      if (!grid.near(other)) continue;
      grid.candidates(other, near);
      for (const HalfEdgeId candidate : near) {
        if (candidate / 3 == f) continue;
        EdgeOverlap one{.edge = candidate, .other = h, .reversed = false, .from = 0, .to = 1};
        if (!overlap(segment(mesh, candidate), other, tolerance, one)) continue;
        found.push_back(one);
        for (const VertexId v : mesh.facets[f]) vertices[v] = true;
      }
    }
  }
  // An edge with an exact partner is closed already: another body's edge that happens to lie there is no
  // neighbour.
  std::unordered_set<HalfEdgeId> closed;
  EdgeTable(mesh, &vertices).for_each_edge([&](std::span<const HalfEdgeId> edge) {
    if (edge.size() > 1) closed.insert(edge.begin(), edge.end());
  });
  std::erase_if(found, [&](const EdgeOverlap& one) { return closed.contains(one.other); });
  return found;
}

}  // namespace gabarit
