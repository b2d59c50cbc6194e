#include "checks/ray_probe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "checks/ray_exits.h"
#include "gpu/ray_cast.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t rays_at_once = 1 << 20;

struct Distance {
  double value = infinity, lower = infinity, upper = infinity;
  double greatest = infinity;  // over the cell
  Vec3d end;
  Exit exit = Exit::none;
};

class RayProbe {
 public:
  RayProbe(const ContactSurface& surface, const TriangleMesh& mesh, const RayOptions& options)
      : surface_(&surface), mesh_(&mesh), options_(options) {
    options_.rays = ray_count(options);
  }

  void operator()(std::span<const CellQuery> queries, std::span<CellAnswer> answers) const {
    const auto each = static_cast<std::size_t>(options_.rays);
    const std::size_t step = std::max<std::size_t>(1, rays_at_once / each);
    for (std::size_t i = 0; i < queries.size(); i += step) {
      const std::size_t n = std::min(step, queries.size() - i);
      measure(queries.subspan(i, n), answers.subspan(i, n));
    }
  }

 private:
  void measure(std::span<const CellQuery> queries, std::span<CellAnswer> answers) const {
    const auto each = static_cast<std::size_t>(options_.rays);
    std::vector<Ray> rays(queries.size() * each);
    for (std::size_t i = 0; i < rays.size(); ++i)
      rays[i] = ray(queries[i / each], static_cast<int>(i % each));
    std::vector<RayHit> hits(rays.size());
    cast_rays(surface_->tree, rays, hits);
    for (std::size_t i = 0; i < queries.size(); ++i)
      answers[i] = answer(queries[i], std::span(rays).subspan(i * each, each),
                          std::span(hits).subspan(i * each, each));
  }

  Ray ray(const CellQuery& query, int number) const {
    const Vec3d across = number == 0 ? Vec3d{} : sideways(*mesh_, query.facet, query.direction);
    return {query.point, ray_direction(options_, query.direction, across, number), query.facet,
            ray_floor_share * surface_->size};
  }

  Distance distance(const CellQuery& query, const Ray& ray, const RayHit& hit) const {
    if (hit.facet == no_child || hit.distance > options_.greatest)
      return {infinity, options_.greatest, infinity,
              infinity, query.point,       hit.facet == no_child ? Exit::none : Exit::right};
    const double facing = std::fabs(hit.facing);
    const double angle = std::acos(std::min(1.0, facing));
    const double tilt = query.tilt, across = std::sin(angle);
    const double sags = static_cast<double>(hit.sag) + static_cast<double>(query.sag);
    // The wall's plane, nearer by the sags, seen under an angle that is off by the tilt.
    const auto reach = [&](double off, double turn) {
      const double cosine = std::cos(turn);
      return cosine > 1e-9 ? std::max(0.0, hit.distance * facing + off) / cosine : infinity;
    };
    const double aside = static_cast<double>(query.spacing) * across;
    return {hit.distance,
            reach(-sags - aside, std::max(0.0, angle - tilt)),
            reach(sags, std::min(std::numbers::pi / 2, angle + tilt)),
            reach(sags + aside, std::min(std::numbers::pi / 2, angle + tilt)),
            ray.point + hit.distance * ray.direction,
            hit.facing < 0 ? Exit::wrong : Exit::right};
  }

  CellAnswer answer(const CellQuery& query, std::span<const Ray> rays, std::span<const RayHit> hits) const {
    std::vector<Distance> found;
    for (std::size_t i = 0; i < rays.size(); ++i) found.push_back(distance(query, rays[i], hits[i]));
    CellAnswer answer = options_.mean ? mean_of(found) : shortest_of(found);
    const bool inside = options_.side == Side::inside;
    for (const Distance& d : found) {
      if ((d.exit == Exit::wrong && !surface_->closed) || (inside && d.exit == Exit::none))
        answer.absence = Absence::open;
    }
    if (inside && std::isinf(answer.value)) answer.value = options_.greatest;
    return answer;
  }

  static CellAnswer shortest_of(const std::vector<Distance>& found) {
    CellAnswer answer{infinity, infinity, infinity, infinity, found.front().end};
    for (const Distance& d : found) {
      answer.lower = std::min(answer.lower, d.lower);
      answer.upper = std::min(answer.upper, d.upper);
      answer.greatest = std::min(answer.greatest, d.greatest);
      if (d.value < answer.value) answer.value = d.value, answer.contact = d.end;
    }
    return answer;
  }

  static CellAnswer mean_of(const std::vector<Distance>& found) {
    CellAnswer answer{0, 0, 0, 0, found.front().end};
    const auto n = static_cast<double>(found.size());
    for (const Distance& d : found) {
      answer.value += d.value / n, answer.lower += d.lower / n;
      answer.upper += d.upper / n, answer.greatest += d.greatest / n;
    }
    return answer;
  }

  const ContactSurface* surface_;
  const TriangleMesh* mesh_;
  RayOptions options_;
};

}  // namespace

int ray_count(const RayOptions& options) { return options.cone > 0 ? options.rays : 1; }

// A sunflower over the cap: equal shares of solid angle.
Vec3d ray_direction(const RayOptions& options, const Vec3d& axis, const Vec3d& sideways, int number) {
  if (number == 0) return axis;
  const double z = 1 - (1 - std::cos(options.cone)) * number / (options.rays - 1);
  const double around = number * std::numbers::pi * (3 - std::sqrt(5.0));
  const Vec3d other = cross(axis, sideways);
  const double across = std::sqrt(std::max(0.0, 1 - z * z));
  return normalized(z * axis + across * (std::cos(around) * sideways + std::sin(around) * other));
}

Vec3d sideways(const TriangleMesh& mesh, FacetId f, const Vec3d& axis) {
  Vec3d longest;
  for (int k = 0; k < 3; ++k) {
    const Vec3d edge = mesh.corner(f, (k + 1) % 3) - mesh.corner(f, k);
    if (squared_length(edge) > squared_length(longest)) longest = edge;
  }
  return normalized(longest - dot(longest, axis) * axis);
}

Probe ray_probe(const ContactSurface& surface, const TriangleMesh& mesh, const RayOptions& options) {
  return RayProbe(surface, mesh, options);
}

}  // namespace gabarit
