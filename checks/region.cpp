#include "checks/region.h"

namespace gabarit {

std::vector<FacetId> selected_facets(const Region& region) {
  std::vector<FacetId> facets;
  for (FacetId f = 0; f < region.facets.size(); ++f) {
    if (region.facets[f] != Selected::no) facets.push_back(f);
  }
  return facets;
}

}  // namespace gabarit
