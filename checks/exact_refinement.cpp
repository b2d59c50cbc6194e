#include "checks/exact_refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least_step = 2e-5;  // mm
constexpr double near_the_least = 1.05;
constexpr int grid = 4;

using Weights = std::array<double, 2>;

// What is known of the least place of one facet.
struct Descent {
  std::size_t row = 0;
  Weights at{};
  ExactWall least;
  double step = 1.0 / (2 * grid);  // of the weights
  double size = 0;                 // the facet's longest edge, mm
  bool sound = true;               // every ball was verified

  bool done() const { return step * size < least_step; }
};

Weights on_facet(double v, double w) {
  v = std::clamp(v, 0.0, 1.0), w = std::clamp(w, 0.0, 1.0);
  const double over = v + w - 1;
  return over > 0 ? Weights{v - over / 2, w - over / 2} : Weights{v, w};
}

// Six ways from a place, none for facets that are done.
std::vector<FacetPlace> neighbours(const Field& field, const std::vector<Descent>& descents) {
  std::vector<FacetPlace> places;
  for (const Descent& d : descents) {
    if (d.done()) continue;
    const double s = d.step;
    for (const auto& [v, w] : {Weights{s, 0}, {-s, 0}, {0, s}, {0, -s}, {s, -s}, {-s, s}})
      places.push_back({field.facets[d.row], on_facet(d.at[0] + v, d.at[1] + w)});
  }
  return places;
}

// Of the place on the facet that is nearest to p.
Weights weights_of(const TriangleMesh& mesh, FacetId facet, const Vec3d& p) {
  const auto [a, b, c] = mesh.corners(facet);
  const Vec3d ab = b - a, ac = c - a, ap = p - a, n = cross(ab, ac);
  const double area = squared_length(n);
  return area > 0 ? on_facet(dot(cross(ap, ac), n) / area, dot(cross(ab, ap), n) / area) : Weights{};
}

// A grid, and the best place so far.
void start(const Field& field, const TriangleMesh& mesh, const ExactMeasure& walls,
           std::vector<Descent>& descents) {
  std::vector<FacetPlace> places;
  for (const Descent& d : descents) {
    const FacetId facet = field.facets[d.row];
    places.push_back({facet, weights_of(mesh, facet, field.at[d.row])});
    for (int i = 0; i <= grid; ++i) {
      for (int j = 0; i + j <= grid; ++j)
        places.push_back({facet, {static_cast<double>(i) / grid, static_cast<double>(j) / grid}});
    }
  }
  const std::vector<ExactWall> found = walls(places);
  const std::size_t each = descents.empty() ? 0 : places.size() / descents.size();
  for (std::size_t i = 0; i < places.size(); ++i) {
    Descent& d = descents[i / each];
    if (!found[i].measured) continue;
    d.sound = d.sound && found[i].ball.verified && !found[i].at_edge;
    if (found[i].at_edge) continue;
    if (found[i].value < d.least.value) d.least = found[i], d.at = places[i].weights;
  }
}

void descend(const Field& field, const ExactMeasure& walls, std::vector<Descent>& descents) {
  for (std::vector<FacetPlace> places = neighbours(field, descents); !places.empty();
       places = neighbours(field, descents)) {
    const std::vector<ExactWall> found = walls(places);
    std::size_t i = 0;
    for (Descent& d : descents) {
      if (d.done()) continue;
      bool better = false;
      for (int k = 0; k < 6; ++k, ++i) {
        if (!found[i].measured) continue;
        d.sound = d.sound && found[i].ball.verified && !found[i].at_edge;
        if (found[i].at_edge) continue;
        if (!(found[i].value < d.least.value * (1 - 1e-12))) continue;
        d.least = found[i], d.at = places[i].weights, better = true;
      }
      if (!better) d.step /= 2;
    }
  }
}

void keep(Field& field, const Descent& d, const RefineOptions& options) {
  if (!d.least.measured || !std::isfinite(d.least.value)) return;
  const std::size_t row = d.row;
  const double least = rounded_wall(d.least.value);
  // What the facets' own bounds exclude was not found, or counts on the surfaces only.
  if (options.facets_bind && least > field.upper[row] * (1 + 1e-6)) return;
  if (options.facets_bind && least < field.lower[row] * (1 - 1e-6)) {
    field.lower[row] = least - d.least.off;
    return;
  }
  if (least < field.value[row]) {
    field.value[row] = least;
    field.at[row] = d.least.at;
    field.contact[row] = d.least.ball.contact;
  }
  field.upper[row] = std::min(field.upper[row], least + d.least.off);
  const double lower = std::min(field.value[row], least) - d.least.off;
  if (d.sound && options.limit > 0) field.lower[row] = std::max(field.lower[row], lower);
  field.lower[row] = std::min(field.lower[row], field.value[row]);
}

bool is_least_around(const Field& field, const std::vector<double>& by_facet, const Scene& scene,
                     std::size_t row) {
  const auto around = scene.adjacency().of(field.facets[row]);
  return std::all_of(around.begin(), around.end(),
                     [&](const EdgeNeighbour& n) { return by_facet[n.facet] >= field.value[row]; });
}

}  // namespace

void refine_least(Field& field, const Scene& scene, const ExactMeasure& walls, const RefineOptions& options) {
  const double limit = options.limit;
  std::vector<double> by_facet(scene.mesh().facet_count(), infinity);
  double least = infinity;
  for (std::size_t row = 0; row < field.size(); ++row) {
    if (field.absence[row] != Absence::none) continue;
    by_facet[field.facets[row]] = field.value[row];
    least = std::min(least, field.value[row]);
  }
  const double thin = std::max(limit, near_the_least * least);
  std::vector<Descent> descents;
  for (std::size_t row = 0; row < field.size(); ++row) {
    if (field.absence[row] != Absence::none) continue;
    const bool open = limit > 0 && field.lower[row] < limit && limit <= field.upper[row];
    if (!open && !(field.value[row] <= thin && is_least_around(field, by_facet, scene, row))) continue;
    const auto [a, b, c] = scene.mesh().corners(field.facets[row]);
    Descent descent;
    descent.row = row;
    descent.size = std::max({length(b - a), length(c - b), length(a - c)});
    descents.push_back(descent);
  }
  start(field, scene.mesh(), walls, descents);
  descend(field, walls, descents);
  for (const Descent& d : descents) keep(field, d, options);
}

}  // namespace gabarit
