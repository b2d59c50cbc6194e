#include <array>

#include "checks/body.h"
#include "checks/box.h"
#include "checks/check.h"
#include "checks/clearance.h"
#include "checks/facing.h"
#include "checks/height.h"
#include "checks/radius.h"
#include "checks/thickness.h"
#include "checks/vertical_cylinder_contact.h"

namespace gabarit {

std::span<const Selector* const> all_selectors() {
  static constexpr std::array all{&vertical_cylinder_contact_selector, &height_selector, &box_selector,
                                  &facing_selector, &body_selector};
  return all;
}

std::span<const Measure* const> all_measures() {
  static constexpr std::array all{&radius_measure, &thickness_measure, &clearance_measure};
  return all;
}

Region whole_model(const TriangleMesh& mesh) {
  Region region;
  region.facets.assign(mesh.facet_count(), Selected::yes);
  return region;
}

}  // namespace gabarit
