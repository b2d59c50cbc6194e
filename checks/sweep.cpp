#include "checks/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gabarit {
namespace {

// Between places that are compared, mm; more when the path is so long that they would not fit in memory.
double spacing_of(const DiskPath& path) {
  double all = 0;
  for (const PathPiece& piece : path.pieces)
    all += piece.arc ? (piece.to_angle - piece.from_angle) * path.radius : length(piece.to - piece.from);
  return std::max(0.05, all / 2e6);
}

int steps_of(const PathPiece& piece, double radius, double spacing) {
  const double l = piece.arc ? (piece.to_angle - piece.from_angle) * radius : length(piece.to - piece.from);
  return 1 + static_cast<int>(l / spacing);
}

Point2 place(const PathPiece& piece, double radius, double t) {
  if (!piece.arc) return piece.from + (piece.to - piece.from) * t;
  const double angle = piece.from_angle + (piece.to_angle - piece.from_angle) * t;
  return piece.centre + Point2{std::cos(angle), std::sin(angle)} * radius;
}

PathPiece part(const PathPiece& piece, double radius, double t0, double t1) {
  PathPiece cut = piece;
  cut.from = place(piece, radius, t0);
  cut.to = place(piece, radius, t1);
  cut.from_angle = piece.from_angle + (piece.to_angle - piece.from_angle) * t0;
  cut.to_angle = piece.from_angle + (piece.to_angle - piece.from_angle) * t1;
  return cut;
}

// For each x the greatest x + side * y of all places further forward.
class Front {
 public:
  Front(const DiskPath& path, double spacing, double side) {
    for (const PathPiece& piece : path.pieces) {
      const int steps = steps_of(piece, path.radius, spacing);
      for (int i = 0; i <= steps; ++i) {
        const Point2 c = place(piece, path.radius, static_cast<double>(i) / steps);
        records_.push_back({c.x, c.x + side * c.y});
      }
    }
    std::sort(records_.begin(), records_.end(),
              [](Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    double most = -std::numeric_limits<double>::infinity();
    for (Point2& r : records_) r.y = most = std::max(most, r.y);
  }
  double before(double x) const {
    const auto next = std::lower_bound(records_.begin(), records_.end(), x - 1e-9,
                                       [](Point2 a, double b) { return a.x < b; });
    return next == records_.begin() ? -std::numeric_limits<double>::infinity() : std::prev(next)->y;
  }

 private:
  std::vector<Point2> records_;
};

}  // namespace

DiskPath sweep_part(const DiskPath& path) {
  const double spacing = spacing_of(path);
  DiskPath out{.radius = path.radius, .pieces = {}, .components = path.components, .contours = {}};
  for (const double side : {1.0, -1.0}) {
    const Front front(path, spacing, side);
    for (const PathPiece& piece : path.pieces) {
      const int steps = steps_of(piece, path.radius, spacing);
      int begin = -1;
      for (int i = 0; i <= steps + 1; ++i) {
        const Point2 c = place(piece, path.radius, std::min(1.0, static_cast<double>(i) / steps));
        const bool kept = i <= steps && c.x + side * c.y >= front.before(c.x) - 2 * spacing;
        if (kept && begin < 0) begin = i;
        if (!kept && begin >= 0) {
          const double t0 = std::max(0, begin - 1);
          const double t1 = std::min(steps, i);
          out.pieces.push_back(part(piece, path.radius, t0 / steps, t1 / steps));
          begin = -1;
        }
      }
    }
  }
  return out;
}

}  // namespace gabarit
