#include "checks/ray_exits.h"

#include "gpu/ray_cast.h"

namespace gabarit {

std::vector<Exit> exits_of(const ContactSurface& surface, std::span<const CellQuery> queries, double from) {
  std::vector<Ray> rays(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i)
    rays[i] = {queries[i].point, queries[i].direction, queries[i].facet, from};
  std::vector<RayHit> hits(queries.size());
  cast_rays(surface.tree, rays, hits);
  std::vector<Exit> exits(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    exits[i] = hits[i].facet == no_child ? Exit::none : hits[i].facing < 0 ? Exit::wrong : Exit::right;
  }
  return exits;
}

}  // namespace gabarit
