#include "checks/contact_depth.h"

#include <algorithm>
#include <limits>

namespace gabarit {

// Lines, and the ends of arcs once.
static std::vector<Segment2> centres(const DiskPath& path) {
  std::vector<Segment2> lines;
  std::vector<Point2> ends;
  for (const PathPiece& piece : path.pieces) {
    if (piece.arc) {
      ends.push_back(piece.from);
      ends.push_back(piece.to);
    } else {
      lines.push_back({piece.from, piece.to});
    }
  }
  std::sort(ends.begin(), ends.end(), [](Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i == 0 || length(ends[i] - ends[i - 1]) > 1e-9) lines.push_back({ends[i], ends[i]});
  }
  return lines;
}

static std::vector<Segment2> segments_of(const std::vector<PlanSide>& sides) {
  std::vector<Segment2> segments;
  segments.reserve(sides.size());
  for (const PlanSide& side : sides) segments.push_back({side.from, side.to});
  return segments;
}

ContactDepth::ContactDepth(const std::vector<PlanSide>& sides, double radius)
    : sides_(segments_of(sides)), grid_(sides_, radius / 64) {}

std::vector<float> ContactDepth::along(const DiskPath& path, double tolerance) const {
  std::vector<float> depth(sides_.size(), std::numeric_limits<float>::infinity());
  const double reach = path.radius + tolerance;
  for (const Segment2& centre : centres(path)) {
    Box2 box;
    box.add(centre.from);
    box.add(centre.to);
    const auto near = [&](Point2 low, Point2 high) { return box_gap(low, high, box) <= reach; };
    grid_.visit(box.low, box.high, reach, near, [&](std::uint32_t i) {
      const double d = segment_distance(centre.from, centre.to, sides_[i].from, sides_[i].to);
      if (d <= reach) depth[i] = std::min(depth[i], static_cast<float>(d - path.radius));
    });
  }
  return depth;
}

}  // namespace gabarit
