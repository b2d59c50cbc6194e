// Walls measured on the exact surfaces of a model: the values of another probe's cells, made exact.
#pragma once

#include <cmath>

#include "checks/exact_ball.h"
#include "checks/facet_cells.h"
#include "checks/scene.h"
#include "model/brep_surface.h"

namespace gabarit {

struct ExactWallOptions {
  Side side = Side::inside;
  double separation = 2.0943951023931953;  // radians
  double greatest = 1e300;                 // mm: larger diameters are not looked for
  Extreme extreme = Extreme::smallest;
};

// A place on a facet of a model that has exact surfaces, by the weights of the facet's second and third
// corner.
struct FacetPlace {
  FacetId facet = 0;
  std::array<double, 2> weights{1.0 / 3, 1.0 / 3};
};

// The point of the exact surface under a place of a facet.
struct SurfacePlace {
  SurfacePoint point;
  Vec3d normal;          // outward; zero where the surface has none
  bool present = false;  // with a normal, and within the trimming curves: facets hang over the rims of holes
};
SurfacePlace surface_place(const BrepView& brep, const FacetOrigin& facet,
                           const std::array<double, 2>& weights);

// What is reported of exact walls: multiples of 1e-6 mm, so that a wall of 1 mm is not thinner than 1 mm.
inline double rounded_wall(double value) { return std::round(value * 1e6) / 1e6; }

// A wall as thick as a ball's diameter.
struct ExactWall {
  double value = std::numeric_limits<double>::infinity();  // mm; infinite: nothing stops the ball
  double off = 0;         // mm: what the tolerance of an edge leaves open of it
  Vec3d at;               // the place on the exact surface
  bool measured = false;  // the surface has a normal at the place
  bool at_edge = false;   // of rays: it shrinks to nothing towards an edge, however thick the part is
  ExactBall ball;
};

class ExactWalls {
 public:
  // All of them must outlive this.
  ExactWalls(const Scene& scene, const ContactSurface& surface, const ExactWallOptions& options);

  // The same on any number of threads.
  std::vector<ExactWall> measure(std::span<const FacetPlace> places) const;

 private:
  const Scene* scene_;
  const ExactSurface* exact_;
  ExactWallOptions options_;
  ExactBallOptions ball_options_;
};

// The same on any number of threads.
using ExactMeasure = std::function<std::vector<ExactWall>(std::span<const FacetPlace>)>;

// Value, place and upper bound of the answer become those of the surfaces; the lower bound does where the
// greatest value is looked for and the ball was verified, else it may only fall.
void take_value(const ExactWall& wall, Extreme extreme, CellAnswer& answer);

// Values and upper bounds are those of the exact surfaces; what lies between the places of a cell keeps the
// lower bound that `base` gives for facets with their sag.
Probe exact_probe(Probe base, const ExactWalls& walls, Extreme extreme);

}  // namespace gabarit
