#include "checks/plan.h"

#include <algorithm>

namespace gabarit {

double point_segment_distance(Point2 p, Point2 a, Point2 b) {
  const Point2 ab = b - a;
  const double l2 = dot(ab, ab);
  const double t = l2 > 0 ? std::clamp(dot(p - a, ab) / l2, 0.0, 1.0) : 0.0;
  return length(p - (a + ab * t));
}

double segment_distance(Point2 a, Point2 b, Point2 p, Point2 q) {
  const double u = cross(b - a, p - a);
  const double v = cross(b - a, q - a);
  const double w = cross(q - p, a - p);
  const double z = cross(q - p, b - p);
  if (((u > 0) != (v > 0)) && ((w > 0) != (z > 0)) && u != v && w != z) return 0;
  return std::min({point_segment_distance(a, p, q), point_segment_distance(b, p, q),
                   point_segment_distance(p, a, b), point_segment_distance(q, a, b)});
}

}  // namespace gabarit
