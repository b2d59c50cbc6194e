// The first facet that a ray meets.
#pragma once

#include <span>

#include "gpu/bvh.h"

namespace gabarit {

struct Ray {
  Vec3d point, direction;        // unit
  std::uint32_t own = no_child;  // facet that the ray starts on
  double from = 0;               // hits nearer than this do not count
};

struct RayHit {
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t facet = no_child;  // none: the ray escapes
  double facing = 0;               // the hit facet's normal · direction; positive: the ray leaves there
  float sag = 0;                   // of the hit facet
};

// Rays through an edge or vertex hit one of its facets: the test is a hair (1e-9 of the facet) too wide,
// never too narrow. Of equally near facets the one with the smallest id is given.
void cast_rays(const Bvh& tree, std::span<const Ray> rays, std::span<RayHit> hits);

}  // namespace gabarit
