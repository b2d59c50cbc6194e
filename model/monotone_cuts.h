// Cuts a curve in a parameter plane where it turns back.
#pragma once

#include <vector>

#include "model/brep.h"

namespace gabarit {

// The places strictly between `from` and `to` (from < to), ascending, between which u (x) and v (y) of the
// curve each run one way: all roots of both derivatives, and the kinks. A periodic curve may run past its
// end.
std::vector<double> monotone_cuts(const Brep& brep, const Curve& curve, double from, double to);

}  // namespace gabarit
