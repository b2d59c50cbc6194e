// Where a spline surface may bend although it is one face: knots that count as often as its degree.
#pragma once

#include <vector>

#include "model/brep.h"

namespace gabarit {

struct Kinks {
  std::vector<double> u, v;  // parameters inside the domain
};

// One a surface; both lists are empty for nearly all of them.
std::vector<Kinks> kinks(const Brep& brep);

}  // namespace gabarit
