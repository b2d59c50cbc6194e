#include "tests/examples/built.h"

namespace gabarit::motorcycle {

static Built build(const Tessellation& tessellation) {
  Built built{tessellation, parts(), {}, {}};
  built.grids = grids(built.parts, tessellation);
  built.model.file = "motorcycle";
  built.model.sag = tessellation.sag;
  built.model.mesh = mesh(built.parts, built.grids);
  built.model.box = bounding_box(built.model.mesh);
  for (const Part& part : built.parts) built.model.bodies.push_back(part.name);
  return built;
}

const Built& coarse() {
  static const Built built = build({.sag = 0.2, .step = 3});
  return built;
}

const Built& delivered() {
  static const Built built = build({});
  return built;
}

}  // namespace gabarit::motorcycle
