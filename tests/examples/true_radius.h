// The smallest convex radius of the true surfaces, where a column touches their facets.
#pragma once

#include <array>

#include "checks/region.h"
#include "examples/motorcycle/motorcycle.h"
#include "examples/motorcycle/outline.h"

namespace gabarit::motorcycle {

// Which parameters a facet of a surface covers: its three corners as (u, v), the ends of the surface
// included.
struct ParameterTriangle {
  std::array<Vec2, 3> corners;
};
ParameterTriangle parameters(const Surface& surface, const Grid& grid, std::size_t facet);

// 1 / the largest principal curvature towards the inside; infinite where the surface is flat or hollow.
// Central differences of the surface inside `from` to `to`, without crossing a break.
double convex_radius(const Surface& surface, Vec2 at, Vec2 half_width);

// Whether the surface has a convex crease (more than 1 degree) on a break there. `along_u`: the break is a
// line u = constant.
bool convex_crease(const Surface& surface, Vec2 at, bool along_u);

// One a part: the smallest convex radius among the touched facets and the creases among their touched edges;
// 0 sharp, infinite when nothing is touched.
struct TouchedPart {
  std::size_t yes = 0, maybe = 0;
  double radius = 0;
  Vec3d at;  // where
};
std::vector<TouchedPart> touched_parts(const Parts& parts, const std::vector<Grid>& grids,
                                       const Region& region);

}  // namespace gabarit::motorcycle
