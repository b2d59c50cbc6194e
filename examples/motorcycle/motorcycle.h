// The example motorcycle: all parts, their facets, and what the check of a column must find.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "examples/motorcycle/part.h"
#include "examples/motorcycle/tessellate.h"

namespace gabarit::motorcycle {

// Steps (mm) at a sag of 0.1 mm and the facets they give: about 490 thousand, 2.7 million and 12 million.
inline constexpr double usual_step = 1.5, fine_step = 0.615, finest_step = 0.289;

// The true surfaces; no facets yet.
Parts parts();

// The grids of every surface of every part, in order; sets first and last of the parts. Throws
// std::length_error when there are more facets than a model can number.
std::vector<Grid> grids(Parts& parts, const Tessellation& tessellation);
using SingleFacet = std::array<Vec3f, 3>;  // corners as a binary STL holds them
// All facets of all parts in order, one by one.
void tessellate(const Parts& parts, const std::vector<Grid>& grids,
                const std::function<void(const SingleFacet&)>& sink);

// The facets as they would be loaded from the STL. Body b is part b.
TriangleMesh mesh(const Parts& parts, const std::vector<Grid>& grids);

}  // namespace gabarit::motorcycle
