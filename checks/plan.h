// Distances in the plan view.
#pragma once

#include "gpu/point2.h"

namespace gabarit {

// Between the segments ab and pq; 0 when they cross.
double segment_distance(Point2 a, Point2 b, Point2 p, Point2 q);
double point_segment_distance(Point2 p, Point2 a, Point2 b);

}  // namespace gabarit
