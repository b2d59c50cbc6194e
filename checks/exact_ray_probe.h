// Thickness and clearance along rays, measured on the exact surfaces of a model.
#pragma once

#include "checks/exact_probe.h"
#include "checks/exact_ray.h"
#include "checks/ray_probe.h"

namespace gabarit {

class ExactRayWalls {
 public:
  // All of them must outlive this.
  ExactRayWalls(const Scene& scene, const ContactSurface& surface, const RayOptions& options);

  // A wall is as thick as its ray is long, or its cone of rays says; ExactWall::ball holds where the ray ends
  // and whether that is verified. The mean is infinite where one ray meets nothing.
  std::vector<ExactWall> measure(std::span<const FacetPlace> places) const;
  double greatest() const { return options_.greatest; }

 private:
  const Scene* scene_;
  const ContactSurface* surface_;
  RayOptions options_;
};

// As exact_probe(); but a ray may end on another wall than on the facets, beside an edge say, and then
// neither excludes the other: the bounds hold both.
Probe exact_ray_probe(Probe base, const ExactRayWalls& walls, Extreme extreme);

}  // namespace gabarit
