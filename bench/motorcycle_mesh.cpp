#include "bench/motorcycle_mesh.h"

#include <algorithm>

#include "examples/motorcycle/motorcycle.h"

namespace gabarit {

Model motorcycle_mesh(std::size_t facets) {
  motorcycle::Parts parts = motorcycle::parts();
  const auto grids = [&](double step) { return motorcycle::grids(parts, {.sag = 0.1, .step = step}); };
  const auto count = [&] { return static_cast<std::size_t>(parts.back().last); };
  double fine = 0.2;
  double coarse = 8;
  for (int i = 0; i < 16; ++i) {
    const double step = (fine + coarse) / 2;
    grids(step);
    (count() > facets ? fine : coarse) = step;
  }
  Model model;
  model.bodies = {"motorcycle"};
  model.mesh = motorcycle::mesh(parts, grids(coarse));
  model.mesh.body.clear();
  model.box = bounding_box(model.mesh);
  return model;
}

}  // namespace gabarit
