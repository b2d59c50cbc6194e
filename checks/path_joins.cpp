#include "checks/path_joins.h"

#include <algorithm>
#include <numbers>

#include "gpu/segment2.h"

namespace gabarit {
namespace {

struct Meetings {
  Point2 at[2];
  int count = 0;
};

Meetings line_meets_line(const PathPiece& a, const PathPiece& b) {
  const Point2 u = a.to - a.from;
  const Point2 v = b.to - b.from;
  const double turn = cross(u, v);
  // The ends of lines that are as good as parallel tell whether they overlap.
  if (std::abs(turn) <= 1e-12 * length(u) * length(v)) return {};
  return {{a.from + u * (cross(b.from - a.from, v) / turn), {}}, 1};
}

Meetings line_meets_arc(const PathPiece& line, const PathPiece& arc, double radius) {
  const Point2 u = line.to - line.from;
  const double size = length(u);
  if (!(size > 0)) return {};
  const double along = dot(arc.centre - line.from, u) / size;
  const double beside = cross(u, arc.centre - line.from) / size;
  const double half = std::sqrt(std::max(0.0, (radius - beside) * (radius + beside)));
  return {{line.from + u * ((along - half) / size), line.from + u * ((along + half) / size)}, 2};
}

Meetings arc_meets_arc(const PathPiece& a, const PathPiece& b, double radius) {
  const Point2 between = b.centre - a.centre;
  const double squared = dot(between, between);
  if (!(squared > 0)) return {};
  const double half = std::sqrt(std::max(0.0, radius * radius - squared / 4) / squared);
  const Point2 middle = (a.centre + b.centre) * 0.5;
  const Point2 across = Point2{-between.y, between.x} * half;
  return {{middle + across, middle - across}, 2};
}

Meetings meetings(const PathPiece& a, const PathPiece& b, double radius) {
  if (a.arc && b.arc) return arc_meets_arc(a, b, radius);
  if (a.arc) return line_meets_arc(b, a, radius);
  return b.arc ? line_meets_arc(a, b, radius) : line_meets_line(a, b);
}

}  // namespace

double distance(const PathPiece& piece, double radius, Point2 p) {
  if (!piece.arc) return point_segment_distance(p, piece.from, piece.to);
  const Point2 out = p - piece.centre;
  const double angle = std::atan2(out.y, out.x);
  for (const double turned : {angle, angle + 2 * std::numbers::pi}) {
    if (piece.from_angle <= turned && turned <= piece.to_angle) return std::abs(length(out) - radius);
  }
  return std::min(length(p - piece.from), length(p - piece.to));
}

bool meet(const PathPiece& a, const PathPiece& b, double radius, double near) {
  const auto on = [&](const PathPiece& piece, Point2 p, double slack) {
    return distance(piece, radius, p) <= slack;
  };
  if (on(a, b.from, near) || on(a, b.to, near) || on(b, a.from, near) || on(b, a.to, near)) return true;
  const Meetings found = meetings(a, b, radius);
  for (int i = 0; i < found.count; ++i) {
    if (on(a, found.at[i], near / 2) && on(b, found.at[i], near / 2)) return true;
  }
  return false;
}

}  // namespace gabarit
