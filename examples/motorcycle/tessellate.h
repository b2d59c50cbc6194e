// Surfaces into facets, as a CAD system exports them: by sag and step.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "examples/motorcycle/surface.h"

namespace gabarit::motorcycle {

// `sag` is the largest distance between the surface and its facets, `step` the longest edge across a rounding
// of up to 6 mm. Where the surface bends less, edges grow with the square root of the radius (so that the sag
// stays in proportion), up to 40 times the step along straight lines. Diagonals of the quads are longer.
// Millimetres.
struct Tessellation {
  double sag = 0.1, step = 1.5;
};

// The longest edge along a curve of this radius on a surface, mm.
double longest_edge(double radius, const Tessellation& tessellation);

// The parameter lines of a surface that its facets run along.
struct Grid {
  std::vector<double> u, v;

  // Both ends of u are points unless the surface is a ring.
  std::size_t facet_count(bool ring) const;
};

// The lines follow the breaks; between them their density follows the curvature.
Grid grid(const Surface& surface, const Tessellation& tessellation);

// A cell of the grid and its corners in the order (0, 0), (1, 0), (1, 1), (0, 1).
struct Quad {
  double u0, u1, v0, v1;
  std::array<Vec3d, 4> corners;
};
// Whether a quad is split from its first corner: along the diagonal that is nearer to the surface; of a flat
// quad along the shorter one.
bool splits_at_first(const Surface& surface, const Quad& quad);

using FacetSink = std::function<void(const Vec3d& a, const Vec3d& b, const Vec3d& c)>;
// Gives the facets one by one, outward by the right-hand rule, watertight: a point that facets share is the
// same, bit for bit, in all of them. Holds two rows of points.
void tessellate(const Surface& surface, const Grid& grid, const FacetSink& sink);

}  // namespace gabarit::motorcycle
