#include "checks/outline_features.h"

#include <algorithm>

#include "checks/collinear_edges.h"
#include "model/weld.h"

namespace gabarit {
namespace {

struct Side {
  std::uint32_t low, high;
  bool area_left, area_right;  // seen from low to high
};

std::vector<Side> weld(const std::vector<PlanSide>& sides, std::vector<Vec3d>& points) {
  VertexWeld welder(points, sides.size());
  std::vector<Side> out;
  out.reserve(sides.size());
  for (const PlanSide& side : sides) {
    const Vec3d ends[2] = {{side.from.x, side.from.y, 0}, {side.to.x, side.to.y, 0}};
    VertexId number[2];
    welder.add(ends, number);
    const bool forward = number[0] <= number[1];
    const int turn = forward ? side.turn : -side.turn;
    out.push_back({std::min(number[0], number[1]), std::max(number[0], number[1]), turn > 0, turn < 0});
  }
  std::sort(out.begin(), out.end(),
            [](const Side& a, const Side& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  return out;
}

}  // namespace

OutlineFeatures outline_features(const std::vector<PlanSide>& sides) {
  std::vector<Vec3d> welded;
  const std::vector<Side> sorted = weld(sides, welded);
  OutlineFeatures out;
  std::vector<std::uint32_t> number(welded.size(), 0);  // in `out`, plus 1
  const auto keep = [&](std::uint32_t v) {
    if (number[v] == 0) {
      out.points.push_back({welded[v].x, welded[v].y});
      number[v] = static_cast<std::uint32_t>(out.points.size());
    }
    return number[v] - 1;
  };
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin;
    bool left = false;
    bool right = false;
    for (; end < sorted.size() && sorted[end].low == sorted[begin].low &&
           sorted[end].high == sorted[begin].high;
         ++end) {
      left = left || sorted[end].area_left;
      right = right || sorted[end].area_right;
    }
    if (sorted[begin].low == sorted[begin].high) {
      keep(sorted[begin].low);
    } else if (!(left && right)) {
      const std::uint32_t a = keep(sorted[begin].low);
      const std::uint32_t b = keep(sorted[begin].high);
      out.edges.emplace_back(a, b);
      out.area.push_back(left ? 1 : right ? -1 : 0);
    }
    begin = end;
  }
  return join_collinear(out);
}

}  // namespace gabarit
