#include "checks/reachable_sides.h"

#include "checks/certified.h"

namespace gabarit {

// 1 or -1 when the polygon lies strictly to one side of its side i.
static int turn_of(const PlanPolygon& polygon, int i) {
  for (int k = 2; k < polygon.size; ++k) {
    const int side = side_of_line(polygon.corner[i], polygon.next(i), polygon.corner[(i + k) % polygon.size]);
    if (side != 0) return side;
  }
  return 0;
}

std::vector<PlanSide> reachable_sides(const PlanProjection& plan, const ReachGrid& grid) {
  std::vector<PlanSide> sides;
  for (FacetId f = 0; f < plan.facet_count(); ++f) {
    if (grid.reached()[f] == 0) continue;
    const PlanPolygon polygon = plan.polygon(f);
    for (int i = 0; i < polygon.size; ++i)
      sides.push_back({polygon.corner[i], polygon.next(i), f, polygon.edge[i], turn_of(polygon, i)});
  }
  return sides;
}

}  // namespace gabarit
