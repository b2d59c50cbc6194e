#include "checks/contact_depth.h"

#include <algorithm>

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

ContactDepth::ContactDepth(const std::vector<PlanSide>& sides, double radius, const Device& device)
    : sides_(distinct_segments(sides)),
      grid_(sides_.segments, radius / 64),
      rolling_(device, grid_.lists(), sides_.segments) {}

std::vector<float> ContactDepth::along(const DiskPath& path, double tolerance, double apart) const {
  const std::vector<float> depth = rolling_.along(centres(path), {path.radius, tolerance, apart});
  std::vector<float> by_side;
  by_side.reserve(sides_.number.size());
  for (const std::uint32_t i : sides_.number) by_side.push_back(depth[i]);
  return by_side;
}

}  // namespace gabarit
