// One search against the paper's shrinking sphere and bisection: the same points, the same run, one thread.
#pragma once

#include "model/triangle_mesh.h"

namespace gabarit {

struct ThicknessComparison {
  std::size_t facets = 0;
  double ours = 0, capped = 0, paper = 0, bisection = 0;  // microseconds a query; capped: up to 2 mm thick
  double rounds = 0, rounds_of_bisection = 0;             // mean
  double build = 0;                                       // seconds, the tree
  double bytes = 0;                                       // a facet, the tree with all that queries read
  double greatest_difference = 0;                         // mm, of the radius

  double ratio() const { return paper / ours; }
};

// The slow methods run on about `samples` of the points.
ThicknessComparison compare_thickness(const TriangleMesh& mesh, std::size_t samples);

}  // namespace gabarit
