#include "report/section.h"

#include <algorithm>

namespace gabarit {

namespace {

double cross(PagePoint a, PagePoint b) { return a.x * b.y - a.y * b.x; }
PagePoint minus(PagePoint a, PagePoint b) { return {a.x - b.x, a.y - b.y}; }

class Cutter {
 public:
  Cutter(const TriangleMesh& mesh, const Camera& camera)
      : mesh_(mesh), camera_(camera), toward_(camera.toward()) {}

  double height(VertexId v) const { return dot(mesh_.vertices[v] - camera_.target, toward_); }

  // Where the plane cuts the edge between two vertices: the same bits for both facets beside it.
  PagePoint between(VertexId v, VertexId w) const {
    if (v > w) std::swap(v, w);
    const double a = height(v), b = height(w);
    return project(camera_, mesh_.vertices[v] + (a / (a - b)) * (mesh_.vertices[w] - mesh_.vertices[v]));
  }

  void add(FacetId f, Section& section) const {
    const std::array<VertexId, 3>& v = mesh_.facets[f];
    const std::array<double, 3> h{height(v[0]), height(v[1]), height(v[2])};
    if (!is_finite(Vec3d{h[0], h[1], h[2]})) return;
    const auto front = [&](std::size_t i) { return h[i % 3] >= 0; };
    for (std::size_t i = 0; i < 3; ++i) {
      // The corner that lies on its side of the plane alone.
      if (front(i) == front(i + 1) || front(i) == front(i + 2)) continue;
      const PagePoint next = between(v[i], v[(i + 1) % 3]), before = between(v[i], v[(i + 2) % 3]);
      section.push_back(front(i) ? SectionEdge{next, before} : SectionEdge{before, next});
    }
  }

 private:
  const TriangleMesh& mesh_;
  const Camera& camera_;
  Vec3d toward_;
};

struct Crossing {
  double at = 0;
  int enters = 0;  // 1; -1: leaves
};

std::vector<Crossing> crossings(const Section& section, PagePoint start, PagePoint direction) {
  std::vector<Crossing> found;
  for (const SectionEdge& edge : section) {
    const PagePoint a = minus(edge.from, start), b = minus(edge.to, start);
    const double left = cross(direction, a), right = cross(direction, b);
    if ((left < 0) == (right < 0)) continue;
    const double share = left / (left - right);
    const PagePoint there{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    found.push_back({there.x * direction.x + there.y * direction.y, left < 0 ? -1 : 1});
  }
  std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) {
    return a.at != b.at ? a.at < b.at : a.enters > b.enters;
  });
  return found;
}

}  // namespace

Section cut(const TriangleMesh& mesh, const Camera& camera) {
  const Cutter cutter(mesh, camera);
  Section section;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) cutter.add(f, section);
  return section;
}

std::optional<std::vector<Stretch>> material_along(const Section& section, PagePoint start,
                                                   PagePoint direction) {
  std::vector<Stretch> stretches;
  int depth = 0;
  for (const Crossing& crossing : crossings(section, start, direction)) {
    if (depth == 0 && crossing.enters == 1) stretches.push_back({crossing.at, crossing.at});
    depth += crossing.enters;
    if (depth == 0 && crossing.enters == -1) stretches.back().to = crossing.at;
    if (depth < 0) return std::nullopt;
  }
  if (depth != 0) return std::nullopt;
  return stretches;
}

}  // namespace gabarit
