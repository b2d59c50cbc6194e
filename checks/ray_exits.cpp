#include "checks/ray_exits.h"

#include <algorithm>

#include "gpu/ray_cast.h"

namespace gabarit {
namespace {

Exit exit_of(const RayHit& hit) {
  return hit.facet == no_child ? Exit::none : hit.facing < 0 ? Exit::wrong : Exit::right;
}

// Where bodies touch, a ray that leaves the one enters the other at the same place.
void forgive_touching(const ContactSurface& surface, const std::vector<Ray>& rays,
                      const std::vector<RayHit>& hits, double from, std::vector<Exit>& exits) {
  std::vector<Ray> again;
  std::vector<std::size_t> number;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (exits[i] != Exit::wrong) continue;
    again.push_back(
        {rays[i].point, rays[i].direction, hits[i].facet, std::max(from, hits[i].distance - from)});
    number.push_back(i);
  }
  std::vector<RayHit> beside(again.size());
  cast_rays(surface.tree, again, beside);
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (exit_of(beside[i]) == Exit::right && beside[i].distance <= hits[number[i]].distance + from)
      exits[number[i]] = Exit::right;
  }
}

}  // namespace

std::vector<Exit> exits_of(const ContactSurface& surface, std::span<const CellQuery> queries, double from) {
  std::vector<Ray> rays(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i)
    rays[i] = {queries[i].point, queries[i].direction, queries[i].facet, from};
  std::vector<RayHit> hits(queries.size());
  cast_rays(surface.tree, rays, hits);
  std::vector<Exit> exits(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) exits[i] = exit_of(hits[i]);
  forgive_touching(surface, rays, hits, from, exits);
  return exits;
}

}  // namespace gabarit
