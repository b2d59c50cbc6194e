// Segments and distances in the plan view.
#pragma once

#include "gpu/point2.h"

namespace gabarit {

struct Segment2 {
  Point2 from, to;  // the same for a point
};

GABARIT_HD inline Point2 nearest_point(Point2 p, const Segment2& s) {
  const Point2 along = s.to - s.from;
  const double squared = dot(along, along);
  const double t = squared > 0 ? dot(p - s.from, along) / squared : 0.0;
  return s.from + along * (t < 0 ? 0 : t > 1 ? 1 : t);
}

GABARIT_HD inline double point_segment_distance(Point2 p, Point2 a, Point2 b) {
  return length(p - nearest_point(p, {a, b}));
}

// Between the segments ab and pq; 0 when they cross.
GABARIT_HD inline double segment_distance(Point2 a, Point2 b, Point2 p, Point2 q) {
  const double u = cross(b - a, p - a);
  const double v = cross(b - a, q - a);
  const double w = cross(q - p, a - p);
  const double z = cross(q - p, b - p);
  if (((u > 0) != (v > 0)) && ((w > 0) != (z > 0)) && u != v && w != z) return 0;
  const auto lesser = [](double d, double e) { return e < d ? e : d; };
  return lesser(lesser(point_segment_distance(a, p, q), point_segment_distance(b, p, q)),
                lesser(point_segment_distance(p, a, b), point_segment_distance(q, a, b)));
}

}  // namespace gabarit
