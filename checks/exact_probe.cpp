#include "checks/exact_probe.h"

#include <algorithm>
#include <cmath>

#include "model/brep_foot.h"

namespace gabarit {
namespace {

constexpr double floor_share = 1e-6;  // of the model's size: contacts nearer than that are the surface itself

void make_exact(const ExactWall& wall, Extreme extreme, CellAnswer& answer) {
  if (!wall.measured || answer.absence != Absence::none || !std::isfinite(wall.value)) return;
  // What the facets' own bounds exclude was not found, or counts on the surfaces only: then the facets keep
  // the word, but a place that the surfaces call thinner is not known to be as thick as the facets say.
  if (wall.value > answer.upper * (1 + 1e-6)) return;
  if (wall.value < answer.lower * (1 - 1e-6)) {
    answer.lower = wall.value - wall.off;
    return;
  }
  take_value(wall, extreme, answer);
}

}  // namespace

void take_value(const ExactWall& wall, Extreme extreme, CellAnswer& answer) {
  answer.value = rounded_wall(wall.value);
  answer.at = wall.at;
  answer.contact = wall.ball.contact;
  answer.upper = answer.value + wall.off;
  const double lower = answer.value - wall.off;
  answer.lower = extreme == Extreme::greatest && wall.ball.verified ? lower : std::min(answer.lower, lower);
  answer.greatest = std::max(answer.greatest, answer.upper);
}

SurfacePlace surface_place(const BrepView& brep, const FacetOrigin& facet,
                           const std::array<double, 2>& weights) {
  const auto [v, w] = weights;
  const Face& face = brep.faces[facet.face];
  const Parameters at = parameters_at(facet, 1 - v - w, v, w);
  SurfacePlace place{face_point(brep, face, at), {}, false};
  place.normal = outward_normal_at(brep, face, place.point);
  place.present = place.normal != Vec3d{} && trim_side(brep, facet.face, at) == TrimSide::inside;
  return place;
}

ExactWalls::ExactWalls(const Scene& scene, const ContactSurface& surface, const ExactWallOptions& options)
    : scene_(&scene), exact_(&scene.exact_surface(options.side)), options_(options) {
  ball_options_ = {.cos_separation = std::cos(options.separation),
                   .greatest_radius = options.greatest / 2,
                   .contact_floor = floor_share * surface.size};
}

std::vector<ExactWall> ExactWalls::measure(std::span<const FacetPlace> places) const {
  std::vector<ExactWall> walls(places.size());
  const Brep& brep = *scene_->model().brep;
  const BrepView faces = view(brep);
  const double side = options_.side == Side::inside ? 1 : -1;
  std::vector<ExactBallQuery> queries;
  std::vector<std::size_t> number;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const FacetOrigin& origin = brep.facets[places[i].facet];
    const SurfacePlace there = surface_place(faces, origin, places[i].weights);
    walls[i].at = there.point.p, walls[i].measured = there.present;
    if (!there.present) continue;
    const PrincipalCurvatures k = principal_curvatures(there.point, brep.faces[origin.face].sign);
    queries.push_back({there.point.p, there.normal * -side, side > 0 ? k.greatest : -k.least, origin.face});
    number.push_back(i);
  }
  std::vector<ExactBall> balls(queries.size());
  exact_balls(*exact_, ball_options_, queries, balls);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    ExactWall& wall = walls[number[i]];
    const ExactBall& ball = wall.ball = balls[i];
    wall.value = 2 * ball.radius;
    const double ahead = dot(ball.contact - queries[i].point, queries[i].direction);
    const double by_edge = ball.edge == no_number ? 0 : 2 * ball.tolerance * ball.radius / ahead;
    // What rounding hides is no doubt.
    wall.off = ball.kind == BallContact::none || by_edge < 5e-7 ? 0 : by_edge;
  }
  return walls;
}

Probe exact_probe(Probe base, const ExactWalls& walls, Extreme extreme) {
  return [base = std::move(base), &walls, extreme](std::span<const CellQuery> queries,
                                                   std::span<CellAnswer> answers) {
    base(queries, answers);
    std::vector<FacetPlace> places;
    places.reserve(queries.size());
    for (const CellQuery& q : queries) places.push_back({q.facet, q.weights});
    const std::vector<ExactWall> found = walls.measure(places);
    for (std::size_t i = 0; i < answers.size(); ++i) make_exact(found[i], extreme, answers[i]);
  };
}

}  // namespace gabarit
