#include "checks/reachable_sides.h"

#include "checks/certified.h"

namespace gabarit {

// 1 or -1 when the polygon with these sides lies strictly to one side of side i.
static int turn_of(std::span<const PlanSide> polygon, std::size_t i) {
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const Point2 corner = polygon[(i + k) % polygon.size()].from;
    if (const int side = side_of_line(polygon[i].from, polygon[i].to, corner); side != 0) return side;
  }
  return 0;
}

// What rounding may have decided is decided exactly.
static void settle_turns(std::vector<PlanSide>& sides) {
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].facet == sides[begin].facet) ++end;
    for (std::size_t i = begin; i < end; ++i) {
      if (sides[i].turn == doubtful_turn)
        sides[i].turn = turn_of(std::span(sides).subspan(begin, end - begin), i - begin);
    }
  }
}

std::vector<PlanSide> reachable_sides(const PlanProjection& plan, const ReachGrid& grid) {
  std::vector<FacetId> reached;
  for (FacetId f = 0; f < plan.facet_count(); ++f) {
    if (grid.reached()[f] != 0) reached.push_back(f);
  }
  std::vector<PlanSide> sides = plan_sides(plan.facets(), reached);
  settle_turns(sides);
  return sides;
}

}  // namespace gabarit
