#include "checks/exact_ray_probe.h"

#include <algorithm>

#include "model/brep_curvature.h"
#include "model/brep_trim.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least_doubt = 5e-7;  // mm: what rounding to 1e-6 mm hides

// What the rays of one place come to.
void settle(std::span<const ExactRay> rays, bool mean, ExactWall& wall) {
  double least = infinity, lower = infinity, upper = infinity, sum = 0, open = 0;
  wall.ball.verified = true;
  for (const ExactRay& ray : rays) {
    wall.ball.verified = wall.ball.verified && ray.verified;
    if (ray.distance < least) wall.ball.contact = ray.end, wall.ball.face = ray.face;
    least = std::min(least, ray.distance);
    lower = std::min(lower, ray.distance - ray.open), upper = std::min(upper, ray.distance + ray.open);
    sum += ray.distance, open += ray.open;
  }
  const auto n = static_cast<double>(rays.size());
  wall.value = mean ? sum / n : least;
  wall.off = mean ? open / n : std::isinf(least) ? 0 : std::max(upper - least, least - lower);
  if (wall.off < least_doubt) wall.off = 0;
}

void make_exact(const ExactWall& wall, Extreme extreme, double greatest, CellAnswer& answer) {
  if (!wall.measured || answer.absence != Absence::none) return;
  if (!(wall.value <= greatest)) {  // the facets know better where to end, or nothing is there
    answer.upper = answer.greatest = infinity;
    return;
  }
  take_value(wall, extreme, answer);
}

// The facet's other cells read no more, whatever the surfaces say here.
bool tells_nothing_new(const CellQuery& query, const CellAnswer& answer) {
  return answer.absence == Absence::none && answer.lower >= query.known && answer.lower >= query.known_upper;
}

// Whether the faces meet at an edge across which the normals turn by a right angle or more: from beside it,
// rays along the normal of the one end on the other.
bool meet_sharply(const Brep& brep, FaceId a, FaceId b, double sign) {
  constexpr double nearly_right = 1.5;  // radians
  if (a == no_number || b == no_number) return false;
  for (std::uint32_t i = brep.first_edge_of_face[a]; i < brep.first_edge_of_face[a + 1]; ++i) {
    const Edge& edge = brep.edges[brep.edges_of_face[i]];
    const double turn = sign > 0 ? edge.greatest_turn : -edge.least_turn;
    if ((edge.faces[0] == b || edge.faces[1] == b) && turn > nearly_right) return true;
  }
  return false;
}

}  // namespace

ExactRayWalls::ExactRayWalls(const Scene& scene, const ContactSurface& surface, const RayOptions& options)
    : scene_(&scene), surface_(&surface), options_(options) {}

std::vector<ExactWall> ExactRayWalls::measure(std::span<const FacetPlace> places) const {
  const Brep& brep = *scene_->model().brep;
  const BrepView faces = view(brep);
  const double sign = options_.side == Side::inside ? 1 : -1;
  const auto each = static_cast<std::size_t>(ray_count(options_));
  std::vector<ExactWall> walls(places.size());
  std::vector<ExactRayQuery> queries;
  std::vector<std::size_t> number;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const FacetOrigin& origin = brep.facets[places[i].facet];
    const SurfacePlace there = surface_place(faces, origin, places[i].weights);
    walls[i].at = there.point.p, walls[i].measured = there.present;
    if (!there.present) continue;
    const Vec3d axis = there.normal * -sign;
    const Vec3d across = each > 1 ? sideways(scene_->mesh(), places[i].facet, axis) : Vec3d{};
    for (std::size_t k = 0; k < each; ++k)
      queries.push_back(
          {there.point.p, ray_direction(options_, axis, across, static_cast<int>(k)), origin.face});
    number.push_back(i);
  }
  std::vector<ExactRay> rays(queries.size());
  exact_rays(
      surface_->tree, scene_->exact_model(),
      {.sign = sign, .floor = ray_floor_share * surface_->size, .slack = 2 * scene_->model().sag.value_or(0)},
      queries, rays);
  for (std::size_t i = 0; i < number.size(); ++i)
    settle(std::span(rays).subspan(i * each, each), options_.mean, walls[number[i]]);
  for (const std::size_t i : number)
    walls[i].at_edge = meet_sharply(brep, brep.facets[places[i].facet].face, walls[i].ball.face, sign);
  return walls;
}

Probe exact_ray_probe(Probe base, const ExactRayWalls& walls, Extreme extreme) {
  return [base = std::move(base), &walls, extreme](std::span<const CellQuery> queries,
                                                   std::span<CellAnswer> answers) {
    base(queries, answers);
    std::vector<FacetPlace> places;
    std::vector<std::size_t> number;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (extreme == Extreme::smallest && tells_nothing_new(queries[i], answers[i])) continue;
      places.push_back({queries[i].facet, queries[i].weights});
      number.push_back(i);
    }
    const std::vector<ExactWall> found = walls.measure(places);
    for (std::size_t i = 0; i < found.size(); ++i)
      make_exact(found[i], extreme, walls.greatest(), answers[number[i]]);
  };
}

}  // namespace gabarit
