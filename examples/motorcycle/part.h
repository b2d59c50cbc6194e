// A named part of the motorcycle and what the check of a column must say about it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "examples/motorcycle/surface.h"
#include "model/triangle_mesh.h"

namespace gabarit::motorcycle {

// What a vertical column of 300 mm finds while the vehicle moves forward.
enum class Expectation {
  violates,      // touched where it is rounded by less than R4
  round,         // touched, and rounded by R4 or more wherever that is so
  rear_facing,   // touched only where it faces backwards, which forward motion leaves out
  out_of_reach,  // not touched, sharp or not
};
const char* name(Expectation expectation);

struct Part {
  std::string name;
  Expectation expectation;
  double true_radius;  // mm: the smallest convex radius that matters; of what is touched, or of the whole
                       // part when nothing is; 0: sharp
  std::string where;   // on the part
  std::vector<Surface> surfaces;
  // Set when the part is tessellated: its facets are [first, last) of the model.
  FacetId first = 0, last = 0;
};

using Parts = std::vector<Part>;

// Adds the part drawn on the right (y > 0) and its mirror image on the left.
void add_pair(Parts& parts, const Part& right);

}  // namespace gabarit::motorcycle
