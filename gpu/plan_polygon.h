// What a height band leaves of a triangle, seen from above.
#pragma once

#include <cstdint>

#include "gpu/point2.h"
#include "gpu/vec3.h"

namespace gabarit {

// Up to five corners. Side i runs from corner i to the next and comes from edge `edge[i]` of the triangle, or
// from the cut (3).
struct PlanPolygon {
  Point2 corner[5];
  std::uint8_t edge[5] = {};
  int size = 0;  // 0: nothing is left

  GABARIT_HD Point2 next(int i) const { return corner[i + 1 < size ? i + 1 : 0]; }
};

// Also false for NaN. Beyond 1000 km a coordinate is rounded by more than 1e-7 mm.
GABARIT_HD inline bool measurable(const Vec3d& p) {
  constexpr double most = 1e9;
  return std::abs(p.x) <= most && std::abs(p.y) <= most && std::abs(p.z) <= most;
}

struct ClippedTriangle {
  struct Corner {
    Vec3d p;
    std::uint8_t edge;  // of the side that starts here
  };
  Corner corner[6];
  int size = 0;

  GABARIT_HD void add(const Vec3d& p, std::uint8_t edge) { corner[size++] = {p, edge}; }
};

// Keeps the side where sign * (z - level) >= 0 (Sutherland and Hodgman, 1974).
GABARIT_HD inline ClippedTriangle clip(const ClippedTriangle& in, double level, double sign) {
  ClippedTriangle out;
  for (int i = 0; i < in.size; ++i) {
    const ClippedTriangle::Corner& a = in.corner[i];
    const ClippedTriangle::Corner& b = in.corner[i + 1 < in.size ? i + 1 : 0];
    const double da = sign * (a.p.z - level);
    const double db = sign * (b.p.z - level);
    if (da >= 0) out.add(a.p, a.edge);
    if ((da >= 0) == (db >= 0)) continue;
    Vec3d cut = a.p + (b.p - a.p) * (da / (da - db));
    cut.z = level;
    // Where the outline leaves the band its next side is the cut; where it comes back, the rest of this edge.
    if (da > 0)
      out.add(cut, 3);
    else if (da == 0)
      out.corner[out.size - 1].edge = 3;
    else if (db > 0)
      out.add(cut, a.edge);
  }
  return out;
}

// Heights are along z; from and to may be infinite. Empty for triangles that are not measurable.
GABARIT_HD inline PlanPolygon plan_polygon(const Vec3d& a, const Vec3d& b, const Vec3d& c, double from,
                                           double to) {
  PlanPolygon out;
  if (!measurable(a) || !measurable(b) || !measurable(c)) return out;
  ClippedTriangle part;
  part.add(a, 0);
  part.add(b, 1);
  part.add(c, 2);
  const double low = a.z < b.z ? (a.z < c.z ? a.z : c.z) : (b.z < c.z ? b.z : c.z);
  const double high = a.z > b.z ? (a.z > c.z ? a.z : c.z) : (b.z > c.z ? b.z : c.z);
  if (low < from) part = clip(part, from, 1);
  if (high > to) part = clip(part, to, -1);
  out.size = part.size < 5 ? part.size : 5;
  for (int i = 0; i < out.size; ++i) {
    out.corner[i] = {part.corner[i].p.x, part.corner[i].p.y};
    out.edge[i] = part.corner[i].edge;
  }
  return out;
}

}  // namespace gabarit
