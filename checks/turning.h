// The radius of convex rounding from how much the surface turns at the edges of its facets.
#pragma once

#include "checks/check.h"

namespace gabarit {

// One side of an edge in a section across it, mm: how far the facet reaches, and the facet's longest side.
struct Leg {
  double length, longest;
};

// The largest radius that a convex edge can be rounded by when the true surface passes through the corners of
// the facets and lies within `sag` (mm) of them: a certain upper bound for an edge that turns by `turn`
// (rad). Between long legs a rounding of radius r turns by at most 2 acos(1 - sag/r). A leg that ends before
// the rounding is furthest from it may end that deep, which is no more than the facet's size allows: l² / 6r.
double largest_rounding(double turn, double sag, const Leg& a, const Leg& b);

Field measure_turning(const Scene& scene, const Setup& setup, const Region& region);

}  // namespace gabarit
