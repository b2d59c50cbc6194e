// Where a point lies along an edge.
#pragma once

#include <limits>

#include "model/brep_curve.h"

namespace gabarit {

// The parameter of the place of the edge's curve that is nearest to p: from the nearest of a row of places by
// Newton's method. Right for points near the curve, where alone it is asked; the edge has a curve.
GABARIT_SEPARATE GABARIT_HD inline double nearest_on_edge(const BrepView& brep, const Edge& edge,
                                                          const Vec3d& p) {
  constexpr int most_steps = 12;
  const Curve& curve = brep.curves[edge.curve];
  const int places = curve.kind == CurveKind::line ? 1 : curve.kind == CurveKind::circle ? 8 : 48;
  double at = edge.first, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= places; ++i) {
    const double t = edge.first + (edge.last - edge.first) * i / places;
    const double distance = squared_length(curve_point(brep, curve, t).p - p);
    if (distance < least) at = t, least = distance;
  }
  for (int i = 0; i < most_steps; ++i) {
    const CurvePoint c = curve_point(brep, curve, at);
    const double first = dot(c.d, c.d), second = first + dot(c.p - p, c.dd);
    double next = at - dot(c.p - p, c.d) / (second > 0.1 * first ? second : first);
    next = next < edge.first ? edge.first : next > edge.last ? edge.last : next;
    const double distance = squared_length(curve_point(brep, curve, next).p - p);
    if (!(distance < least)) break;
    at = next, least = distance;
  }
  return at;
}

// mm; infinite when the edge is but a point.
GABARIT_HD inline double distance_to_edge(const BrepView& brep, const Edge& edge, const Vec3d& p) {
  if (edge.curve == no_number) return std::numeric_limits<double>::infinity();
  return length(curve_point(brep, brep.curves[edge.curve], nearest_on_edge(brep, edge, p)).p - p);
}

}  // namespace gabarit
