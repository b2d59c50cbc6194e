#include "checks/plan_projection.h"

#include <algorithm>
#include <limits>

#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

// Also false for NaN. Beyond 1000 km a coordinate is rounded by more than 1e-7 mm.
bool measurable(const Vec3d& p) {
  constexpr double most = 1e9;
  return std::abs(p.x) <= most && std::abs(p.y) <= most && std::abs(p.z) <= most;
}

struct Corner {
  Vec3d p;
  std::uint8_t edge;  // of the side that starts here
};

struct Clipped {
  std::array<Corner, 6> corner;
  int size = 0;
};

// Keeps the side where sign * (z - level) >= 0 (Sutherland and Hodgman, 1974).
Clipped clip(const Clipped& in, double level, double sign) {
  Clipped out;
  for (int i = 0; i < in.size; ++i) {
    const Corner& a = in.corner[static_cast<std::size_t>(i)];
    const Corner& b = in.corner[static_cast<std::size_t>((i + 1) % in.size)];
    const double da = sign * (a.p.z - level);
    const double db = sign * (b.p.z - level);
    const auto add = [&](const Vec3d& p, std::uint8_t edge) {
      out.corner[static_cast<std::size_t>(out.size++)] = {p, edge};
    };
    if (da >= 0) add(a.p, a.edge);
    if ((da >= 0) == (db >= 0)) continue;
    Vec3d cut = a.p + (b.p - a.p) * (da / (da - db));
    cut.z = level;
    // Where the outline leaves the band its next side is the cut; where it comes back, the rest of this edge.
    if (da >= 0) {
      if (da > 0)
        add(cut, 3);
      else
        out.corner[static_cast<std::size_t>(out.size - 1)].edge = 3;
    } else if (db > 0) {
      add(cut, a.edge);
    }
  }
  return out;
}

}  // namespace

PlanProjection::PlanProjection(const TriangleMesh& mesh, const Frame& frame, const Interval& band,
                               const Device& device)
    : mesh_(&mesh), band_(band), vertices_(mesh.vertices.size()) {
  struct Kernel {
    const Vec3d* in;
    Vec3d* out;
    Frame frame;
    void operator()(std::int64_t i) const { out[i] = frame.to_vehicle(in[i]); }
  };
  parallel_for(device, static_cast<std::int64_t>(vertices_.size()),
               Kernel{mesh.vertices.data(), vertices_.data(), frame}, 65536);
  constexpr double far = std::numeric_limits<double>::infinity();
  low_ = {far, far};
  high_ = {-far, -far};
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const auto& [i, j, k] = mesh.facets[f];
    if (!measurable(vertices_[i]) || !measurable(vertices_[j]) || !measurable(vertices_[k])) ++left_out_;
    const PlanPolygon part = polygon(f);
    for (int n = 0; n < part.size; ++n) {
      const Point2 p = part.corner[static_cast<std::size_t>(n)];
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
  }
}

PlanPolygon PlanProjection::polygon(FacetId f) const {
  PlanPolygon out;
  const auto& facet = mesh_->facets[f];
  Clipped part;
  part.size = 3;
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d& p = vertices_[facet[i]];
    if (!measurable(p)) return out;
    part.corner[i] = {p, static_cast<std::uint8_t>(i)};
    inside = inside && band_.contains(p.z);
  }
  if (!inside) {
    if (std::isfinite(band_.from)) part = clip(part, band_.from, 1);
    if (std::isfinite(band_.to)) part = clip(part, band_.to, -1);
  }
  out.size = std::min(part.size, 5);
  for (std::size_t i = 0; i < static_cast<std::size_t>(out.size); ++i) {
    out.corner[i] = {part.corner[i].p.x, part.corner[i].p.y};
    out.edge[i] = part.corner[i].edge;
  }
  return out;
}

}  // namespace gabarit
