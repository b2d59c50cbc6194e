// Plane geometry of the plan view: x rearward, y to the right, millimetres.
#pragma once

#include <cmath>

#include "gpu/qualifiers.h"

namespace gabarit {

struct Point2 {
  double x = 0, y = 0;

  GABARIT_HD friend constexpr Point2 operator+(Point2 a, Point2 b) { return {a.x + b.x, a.y + b.y}; }
  GABARIT_HD friend constexpr Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
  GABARIT_HD friend constexpr Point2 operator*(Point2 a, double s) { return {a.x * s, a.y * s}; }
  GABARIT_HD friend constexpr bool operator==(Point2 a, Point2 b) { return a.x == b.x && a.y == b.y; }
};

GABARIT_HD constexpr double dot(Point2 a, Point2 b) { return a.x * b.x + a.y * b.y; }
GABARIT_HD constexpr double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }
GABARIT_HD inline double length(Point2 a) { return std::sqrt(dot(a, a)); }

}  // namespace gabarit
