#include "tests/checks/disk_path_reference.h"

#include <algorithm>
#include <numbers>

#include "gpu/segment2.h"

namespace gabarit::reference {
namespace {

double distance(const std::vector<PlanSide>& sides, Point2 c) {
  double nearest = 1e300;
  for (const PlanSide& s : sides) nearest = std::min(nearest, point_segment_distance(c, s.from, s.to));
  return nearest;
}

// Squares that a centre can reach from the border, 8-connected; a square is open when its middle is almost
// free.
class Raster {
 public:
  Raster(const std::vector<PlanSide>& sides, double radius) : size_(radius / 60) {
    Point2 low{1e300, 1e300}, high{-1e300, -1e300};
    for (const PlanSide& s : sides) {
      for (const Point2 p : {s.from, s.to}) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    origin_ = low - Point2{2 * radius, 2 * radius};
    columns_ = static_cast<int>((high.x - low.x + 4 * radius) / size_) + 1;
    rows_ = static_cast<int>((high.y - low.y + 4 * radius) / size_) + 1;
    reached_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
    std::vector<std::pair<int, int>> open{{0, 0}};
    reached_[0] = 1;
    while (!open.empty()) {
      const auto [x, y] = open.back();
      open.pop_back();
      for (int v = std::max(0, y - 1); v <= std::min(rows_ - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(columns_ - 1, x + 1); ++u) {
          if (reached_[index(u, v)] != 0 || distance(sides, middle(u, v)) < radius - 0.55 * size_) continue;
          reached_[index(u, v)] = 1;
          open.emplace_back(u, v);
        }
      }
    }
  }
  bool reached(Point2 c) const {
    const int x = static_cast<int>(std::floor((c.x - origin_.x) / size_));
    const int y = static_cast<int>(std::floor((c.y - origin_.y) / size_));
    for (int v = std::max(0, y - 1); v <= std::min(rows_ - 1, y + 1); ++v) {
      for (int u = std::max(0, x - 1); u <= std::min(columns_ - 1, x + 1); ++u) {
        if (reached_[index(u, v)] != 0) return true;
      }
    }
    return false;
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
  }
  Point2 middle(int x, int y) const { return origin_ + Point2{(x + 0.5) * size_, (y + 0.5) * size_}; }

  double size_;
  Point2 origin_;
  int columns_ = 0, rows_ = 0;
  std::vector<char> reached_;
};

std::vector<Point2> centres(const std::vector<PlanSide>& sides, double radius, double step) {
  std::vector<Point2> out;
  for (const PlanSide& s : sides) {
    const int turns = static_cast<int>(2 * std::numbers::pi * radius / step);
    for (int i = 0; i < turns; ++i) {
      const double a = 2 * std::numbers::pi * i / turns;
      for (const Point2 p : {s.from, s.to}) out.push_back(p + Point2{std::cos(a), std::sin(a)} * radius);
    }
    const Point2 d = s.to - s.from;
    const double l = length(d);
    if (l == 0) continue;
    const Point2 n{-d.y / l, d.x / l};
    const int steps = static_cast<int>(l / step) + 1;
    for (int i = 0; i <= steps; ++i) {
      const Point2 p = s.from + d * (static_cast<double>(i) / steps);
      out.push_back(p + n * radius);
      out.push_back(p - n * radius);
    }
  }
  return out;
}

bool has_near_tie(const std::vector<PlanSide>& sides, double radius) {
  const auto near = [&](double gap) { return gap > 2 * radius * (1 - 0.02) && gap < 2 * radius - 1e-12; };
  for (const PlanSide& a : sides) {
    for (const PlanSide& b : sides) {
      for (const Point2 p : {a.from, a.to}) {
        if (near(point_segment_distance(p, b.from, b.to)) || near(length(p - b.from)) ||
            near(length(p - b.to)))
          return true;
      }
    }
  }
  return false;
}

}  // namespace

Contacts contacts(const std::vector<PlanSide>& sides, double radius, double tolerance) {
  Contacts result;
  result.surely.assign(sides.size(), false);
  result.possibly.assign(sides.size(), false);
  result.near_tie = has_near_tie(sides, radius);
  if (result.near_tie) return result;
  const double step = radius / 250;
  const Raster raster(sides, radius);
  for (const Point2 c : centres(sides, radius, step)) {
    if (distance(sides, c) < radius - 1e-7 || !raster.reached(c)) continue;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const double depth = point_segment_distance(c, sides[i].from, sides[i].to) - radius;
      if (depth <= 1e-6) result.surely[i] = true;
      if (depth <= tolerance + 1.5 * step) result.possibly[i] = true;
    }
  }
  return result;
}

}  // namespace gabarit::reference
