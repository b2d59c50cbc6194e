#include "checks/plan_projection.h"

#include <algorithm>
#include <limits>

#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

struct ToVehicle {
  const Vec3d* in;
  Vec3d* out;
  Frame frame;
  void operator()(std::int64_t i) const { out[i] = frame.to_vehicle(in[i]); }
};

constexpr double beyond = std::numeric_limits<double>::infinity();

// Of some facets.
struct Extent {
  Point2 low{beyond, beyond}, high{-beyond, -beyond};
  std::size_t left_out = 0;

  void add(Point2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  void add(const Extent& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
    left_out += other.left_out;
  }
};

struct FindExtents {
  PlanMesh mesh;
  Extent* out;
  std::int64_t facets;  // in each

  void operator()(std::int64_t chunk) const {
    Extent extent;
    for (std::int64_t f = chunk * facets; f < std::min((chunk + 1) * facets, mesh.facets.size); ++f)
      add(f, extent);
    out[chunk] = extent;
  }

 private:
  void add(std::int64_t facet, Extent& extent) const {
    const auto& [i, j, k] = mesh.facets[facet];
    const Vec3d& a = mesh.points[i];
    const Vec3d& b = mesh.points[j];
    const Vec3d& c = mesh.points[k];
    if (mesh.holds(a) && mesh.holds(b) && mesh.holds(c)) {
      for (const Vec3d& p : {a, b, c}) extent.add(Point2{p.x, p.y});
      return;
    }
    const PlanPolygon part = mesh.polygon(facet);
    for (int n = 0; n < part.size; ++n) extent.add(part.corner[n]);
    if (!measurable(a) || !measurable(b) || !measurable(c)) ++extent.left_out;
  }
};

}  // namespace

PlanProjection::PlanProjection(const TriangleMesh& mesh, const Frame& frame, const Interval& band,
                               const Device& device)
    : mesh_(&mesh), band_(band), vertices_(mesh.vertices.size()) {
  const Device cpu = device.host();
  parallel_for(cpu, static_cast<std::int64_t>(vertices_.size()),
               ToVehicle{mesh.vertices.data(), vertices_.data(), frame}, 65536);
  constexpr std::int64_t facets = 32768;
  std::vector<Extent> extents((mesh.facet_count() + facets - 1) / facets);
  parallel_for(cpu, static_cast<std::int64_t>(extents.size()),
               FindExtents{this->mesh(), extents.data(), facets}, 1);
  Extent all;
  for (const Extent& extent : extents) all.add(extent);
  low_ = all.low;
  high_ = all.high;
  left_out_ = all.left_out;
}

PlanMesh PlanProjection::mesh() const {
  return {view(std::span(vertices_)), view(std::span(mesh_->facets)), band_.from, band_.to};
}

}  // namespace gabarit
