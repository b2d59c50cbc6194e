#include "checks/buried.h"

#include <limits>
#include <utility>

#include "gpu/ray_cast.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// What lies nearer than this share of the model's size lies on the surface itself.
constexpr double floor_share = 1e-6;

// Looks outwards from a hair inside the surface: a body that only touches is entered there, before it is
// left.
std::vector<bool> buried(const ContactSurface& surface, std::span<const CellQuery> queries) {
  const double floor = floor_share * surface.size;
  std::vector<Ray> rays;
  for (const CellQuery& q : queries)
    rays.push_back({q.point + 2 * floor * q.direction, -q.direction, q.facet, floor});
  std::vector<RayHit> hits(rays.size());
  cast_rays(surface.tree, rays, hits);
  std::vector<Ray> beyond;  // of duplicates of the facet itself
  std::vector<std::size_t> number;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].facet == no_child || hits[i].facing < 0 || hits[i].distance > 3 * floor) continue;
    beyond.push_back({queries[i].point, -queries[i].direction, queries[i].facet, floor});
    number.push_back(i);
  }
  std::vector<RayHit> further(beyond.size());
  cast_rays(surface.tree, beyond, further);
  for (std::size_t i = 0; i < number.size(); ++i) hits[number[i]] = further[i];
  std::vector<bool> inside(hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) inside[i] = hits[i].facet != no_child && hits[i].facing > 0;
  return inside;
}

}  // namespace

Probe set_buried_aside(Probe probe, const ContactSurface& surface, double doubt) {
  return [probe = std::move(probe), &surface, doubt](std::span<const CellQuery> queries,
                                                     std::span<CellAnswer> answers) {
    probe(queries, answers);
    std::vector<CellQuery> doubtful;
    std::vector<std::size_t> number;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const CellAnswer& a = answers[i];
      const bool counts = a.value < queries[i].known || a.upper < queries[i].known_upper;
      if (a.absence != Absence::none || !(a.value < doubt) || !counts) continue;
      doubtful.push_back(queries[i]);
      number.push_back(i);
    }
    const std::vector<bool> inside = buried(surface, doubtful);
    for (std::size_t i = 0; i < number.size(); ++i) {
      if (!inside[i]) continue;
      CellAnswer& answer = answers[number[i]];
      answer.absence = Absence::buried;
      answer.value = answer.upper = answer.greatest = infinity;
      answer.contact = doubtful[i].point;
    }
  };
}

}  // namespace gabarit
