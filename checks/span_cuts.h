// Where a parameter range of a surface is cut by the knots of its splines.
#pragma once

#include <vector>

#include "model/brep_view.h"

namespace gabarit {

// `low`, the knots between, each once, in all turns of a periodic parameter, and `high`; of u (along = 0) or
// of v (1).
std::vector<double> span_cuts(const BrepView& brep, const Surface& surface, int along, double low,
                              double high);

}  // namespace gabarit
