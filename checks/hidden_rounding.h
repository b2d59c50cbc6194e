// How large a rounding can hide at an edge of the mesh, between the facets and the true surface.
#pragma once

#include "checks/folds.h"

namespace gabarit {

// One side of an edge in a section across it, mm: how far it runs straight, and the longest side of the
// facets that it runs over.
struct Leg {
  double length, longest;
};

// The most that a rounding of radius r (mm) can turn at an edge, rad, when it passes through the corners of
// the facets and lies within `sag` (mm) of them. Between long legs that is 2 acos(1 - sag/r). A leg that ends
// before the rounding is furthest from it may end that deep, which a facet of longest side l limits to l²/6r.
double most_turn(double r, double sag, const Leg& a, const Leg& b);

// The largest radius whose most_turn reaches `turn`: a certain upper bound of the radius at an edge that
// turns by so much. Infinite when any radius does.
double largest_rounding(double turn, double sag, const Leg& a, const Leg& b);

// The same for a convex fold of facet f: the smallest over three sections across it. Legs run on over facets
// in the same plane.
double largest_rounding(const TriangleMesh& mesh, const Folds& folds, FacetId f, const Fold& fold,
                        double sag);

// Whether the fold turns more than a rounding of radius r can with that sag: the mesh is coarser than it
// says, or this is an edge. One section, legs no longer than the two facets: quick, and never yes without
// need.
bool too_coarse(const TriangleMesh& mesh, FacetId f, const Fold& fold, double r, double sag);

}  // namespace gabarit
