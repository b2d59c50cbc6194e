#include "checks/sphere_placement.h"

#include <limits>

#include "checks/folds.h"
#include "gpu/parallel_for.h"
#include "gpu/tangent_ball.h"

namespace gabarit {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// What one facet's ball says; `closed` is false where an edge has no neighbour to meet.
struct Placed {
  TangentBall ball;
  bool closed = true;
};

Placed place(const TriangleMesh& mesh, const Folds& folds, FacetId f) {
  const Vec3d inward = -facet_normal(mesh, f);
  const Vec3d centre = mesh.centroid(f);
  Placed placed;
  std::array<bool, 3> shared{};
  for (const Fold& fold : folds.of(f)) {
    shared[fold.edge] = true;
    const auto [a, b, c] = mesh.corners(fold.facet);
    const TangentBall ball = ball_through_triangle(inward, a - centre, b - centre, c - centre, infinity);
    if (ball.radius < placed.ball.radius) placed.ball = ball;
  }
  placed.closed = shared[0] && shared[1] && shared[2];
  return placed;
}

}  // namespace

Field measure_sphere_placement(const Scene& scene, const Setup& setup, const Region& region) {
  Field field;
  field.facets = selected_facets(region);
  field.resize(field.facets.size());
  if (field.facets.empty()) return field;
  const TriangleMesh& mesh = scene.mesh();
  const Folds folds(scene, field.facets, 0, setup.sag);
  const auto kernel = [&](std::int64_t i) {
    const auto at = static_cast<std::size_t>(i);
    const FacetId f = field.facets[at];
    const bool has_normal = facet_normal(mesh, f) != Vec3d{};
    const Placed placed = has_normal ? place(mesh, folds, f) : Placed{.ball = {}, .closed = false};
    const bool known = placed.closed || std::isfinite(placed.ball.radius);
    field.value[at] = known ? placed.ball.radius : std::numeric_limits<double>::quiet_NaN();
    field.lower[at] = placed.closed ? placed.ball.radius : 0;
    field.upper[at] = placed.ball.radius;
    field.at[at] = mesh.centroid(f);
    field.contact[at] = field.at[at] + placed.ball.contact;
    field.absence[at] = known ? Absence::none : has_normal ? Absence::open : Absence::degenerate;
  };
  parallel_for_cpu(scene.device(), static_cast<std::int64_t>(field.size()), kernel, 1024);
  return field;
}

}  // namespace gabarit
