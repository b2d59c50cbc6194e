// Plane geometry of the plan view: x rearward, y to the right, millimetres.
#pragma once

#include <cmath>

namespace gabarit {

struct Point2 {
  double x = 0, y = 0;

  friend constexpr Point2 operator+(Point2 a, Point2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Point2 operator*(Point2 a, double s) { return {a.x * s, a.y * s}; }
  friend constexpr bool operator==(Point2, Point2) = default;
};

constexpr double dot(Point2 a, Point2 b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Point2 a, Point2 b) { return a.x * b.y - a.y * b.x; }
inline double length(Point2 a) { return std::sqrt(dot(a, a)); }

// Between the segments ab and pq; 0 when they cross.
double segment_distance(Point2 a, Point2 b, Point2 p, Point2 q);
double point_segment_distance(Point2 p, Point2 a, Point2 b);

}  // namespace gabarit
