// Roundings with known radii for the tests of the radius, meshed in several ways.
#pragma once

#include <vector>

#include "tests/shapes.h"

namespace gabarit::fillets {

enum class Meshing {
  grid,         // squares of about `step`, each cut in two
  long_strips,  // as a CAD system meshes: one strip a chord along the whole edge, single squares for planes
  jittered,     // the grid's corners moved along the surface; the tangent lines stay marked by edges
  jittered_flips,  // the same, squares cut along either diagonal
  unmarked         // the same, corners leave the tangent lines too
};

// Two planes and the rounding between them, open at the rims.
struct Fillet {
  double radius, angle;  // mm, rad
  double step;           // mm
  Meshing meshing = Meshing::grid;
  double plane = 6;    // width of the planes, mm
  double length = 12;  // along the edge, mm
};

enum class Part {
  plane,
  rounding,
  across,  // a good part of the facet lies on either
  border   // near the open rims, or too little of it on the rounding to tell
};

struct Meshed {
  shapes::Triangles triangles;
  std::vector<Part> part;
  double sag;  // of the facets, mm; at least 0.1
};

// The same seed gives the same mesh.
Meshed mesh(const Fillet& fillet, unsigned seed = 1);

// A box with all twelve edges and eight corners rounded, closed: strips of `steps` chords a quarter circle.
shapes::Triangles rounded_box(double size, double radius, int steps);

}  // namespace gabarit::fillets
