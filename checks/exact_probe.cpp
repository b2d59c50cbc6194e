#include "checks/exact_probe.h"

#include <algorithm>
#include <cmath>

#include "model/brep_curvature.h"
#include "model/brep_trim.h"

namespace gabarit {
namespace {

constexpr double floor_share = 1e-6;  // of the model's size: contacts nearer than that are the surface itself

double widest(const std::vector<float>& leans) {
  return leans.empty() ? 0 : static_cast<double>(*std::max_element(leans.begin(), leans.end()));
}

ExactBallScene ball_scene(const Scene& scene, const ContactSurface& surface) {
  const Brep& brep = *scene.model().brep;
  return {.brep = view(brep),
          .facets = surface.tree.view(),
          .origins = view(std::span<const FacetOrigin>(brep.facets)),
          .leans = view(std::span<const float>(scene.facet_leans())),
          .widest_lean = widest(scene.facet_leans()),
          .edges = scene.edges().tree.view(),
          .chords = view(std::span<const EdgeChord>(scene.edges().chords))};
}

void make_exact(const ExactWall& wall, Extreme extreme, CellAnswer& answer) {
  if (!wall.measured || answer.absence != Absence::none || !std::isfinite(wall.value)) return;
  // What the facets' own bounds exclude was not found, or found wrongly: then the facets keep the word.
  if (wall.value > answer.upper * (1 + 1e-6) || wall.value < answer.lower * (1 - 1e-6)) return;
  answer.value = rounded_wall(wall.value);
  answer.at = wall.at;
  answer.contact = wall.ball.contact;
  answer.upper = answer.value + wall.off;
  const double lower = answer.value - wall.off;
  answer.lower = extreme == Extreme::greatest && wall.ball.verified ? lower : std::min(answer.lower, lower);
  answer.greatest = std::max(answer.greatest, answer.upper);
}

}  // namespace

SurfacePlace surface_place(const BrepView& brep, const FacetOrigin& facet,
                           const std::array<double, 2>& weights) {
  const auto [v, w] = weights;
  const Face& face = brep.faces[facet.face];
  const Parameters at = parameters_at(facet, 1 - v - w, v, w);
  SurfacePlace place{face_point(brep, face, at), {}, false};
  place.normal = outward_normal(place.point, face.sign);
  place.present = place.normal != Vec3d{} && trim_side(brep, facet.face, at) == TrimSide::inside;
  return place;
}

ExactWalls::ExactWalls(const Scene& scene, const ContactSurface& surface, const ExactWallOptions& options)
    : scene_(&scene), balls_(ball_scene(scene, surface)), options_(options) {
  ball_options_ = {.cos_separation = std::cos(options.separation),
                   .sign = options.side == Side::inside ? 1.0 : -1.0,
                   .greatest_radius = options.greatest / 2,
                   .contact_floor = floor_share * surface.size};
}

std::vector<ExactWall> ExactWalls::measure(std::span<const FacetPlace> places) const {
  std::vector<ExactWall> walls(places.size());
  std::vector<ExactBallQuery> queries;
  std::vector<std::size_t> number;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const FacetOrigin& origin = balls_.origins[places[i].facet];
    const SurfacePlace there = surface_place(balls_.brep, origin, places[i].weights);
    walls[i].at = there.point.p, walls[i].measured = there.present;
    if (!there.present) continue;
    const PrincipalCurvatures k = principal_curvatures(there.point, balls_.brep.faces[origin.face].sign);
    queries.push_back({there.point.p, there.normal * -ball_options_.sign, places[i].facet,
                       options_.side == Side::inside ? k.greatest : -k.least});
    number.push_back(i);
  }
  std::vector<ExactBall> balls(queries.size());
  exact_balls(scene_->device(), balls_, ball_options_, queries, balls);
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
