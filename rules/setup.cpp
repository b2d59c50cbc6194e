#include "rules/setup.h"

#include <algorithm>

namespace gabarit {

// `up` is parallel to an axis: the lowest corner of the box is as low as the lowest vertex.
static double lowest(const TriangleMesh& mesh, const Vec3d& up) {
  const Box3d box = bounding_box(mesh);
  return box.empty() ? 0.0 : std::min(dot(box.min, up), dot(box.max, up));
}

Setup resolve_setup(const Model& model, const RuleSet& rules, std::optional<double> sag) {
  Setup setup;
  setup.frame.up = rules.up;
  setup.frame.forward = rules.forward;
  setup.frame.ground = rules.ground == Ground::lowest ? lowest(model.mesh, rules.up) : rules.ground_height;
  setup.sag = sag.value_or(model.sag.value_or(rules.sag.value_or(0.1)));
  return setup;
}

}  // namespace gabarit
