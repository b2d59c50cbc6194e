// Decisions of the rolling disk that must not be left to rounding: floating-point filters first, exact
// rationals on doubt.
#pragma once

#include "gpu/point2.h"

namespace gabarit {

// Sign of |vw| - reach.
int compare_distance(Point2 v, Point2 w, double reach);
// Sign of the distance of v from the line through a and b, minus reach.
int compare_line_distance(Point2 v, Point2 a, Point2 b, double reach);
// 1 when c lies left of the line from a to b, -1 right, 0 on it.
int side_of_line(Point2 a, Point2 b, Point2 c);

}  // namespace gabarit
