// The points and edges in plan that a column can touch: what is left of the projected sides after welding and
// after dropping those with projected facets on both sides.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/plan_sides.h"

namespace gabarit {

struct OutlineFeatures {
  std::vector<Point2> points;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;  // of points; never the same point twice
  // By edge, the side on which projected facets lie: 1 left, -1 right, 0 none. No disk touches it from there.
  std::vector<std::int8_t> area;
};

// Sides that are equal in plan count once. An edge with projected area strictly on both sides lies inside the
// projection: no column can touch its inner points (orientations are exact). Points of no edge that is left
// are dropped with it, isolated points stay. Edges along x or y that lie on one line are joined (see
// join_collinear).
OutlineFeatures outline_features(const std::vector<PlanSide>& sides);

}  // namespace gabarit
