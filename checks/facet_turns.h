// How exact surfaces turn where facets of different faces meet, and inside facets where one face has a kink.
#pragma once

#include <vector>

#include "gpu/device.h"
#include "model/brep.h"
#include "model/triangle_mesh.h"

namespace gabarit {

// Radians by half-edge (3 · facet + edge): the most that the outward normal turns along it, convex is
// positive; 0 inside a face. Infinite at a free edge or where more than two facets meet: nobody knows.
std::vector<float> facet_turns(const Brep& brep, const TriangleMesh& mesh, const Device& device);

// Radians by facet: the most that a face turns convexly at a kink that crosses the facet, mostly 0. Empty
// when no face has kinks.
std::vector<float> kink_turns(const Brep& brep, const Device& device);

}  // namespace gabarit
