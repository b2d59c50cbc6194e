#include "model/polygon.h"

#include <cmath>
#include <deque>

namespace gabarit {
namespace {

Vec3d newell_normal(std::span<const Vec3d> polygon) {
  Vec3d n;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    n += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  return n;
}

struct Point {
  double x, y;
  bool operator==(const Point&) const = default;
};

// Twice the signed area: positive when a, b, c turn left.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The coordinate along which the polygon is largest is dropped: no rounding, and the sense of rotation stays.
std::vector<Point> flattened(std::span<const Vec3d> polygon) {
  const Vec3d n = newell_normal(polygon);
  const Vec3d size{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
  const int dropped = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  const int u = (dropped + 1) % 3;
  const int v = (dropped + 2) % 3;
  std::vector<Point> points;
  points.reserve(polygon.size());
  for (const Vec3d& p : polygon) points.push_back(n[dropped] < 0 ? Point{p[v], p[u]} : Point{p[u], p[v]});
  return points;
}

// Ear clipping (Meisters, Polygons have ears, 1975): a corner is looked at again only when its neighbours
// change, and only corners that are not convex can lie in an ear.
class EarClipping {
 public:
  explicit EarClipping(std::span<const Vec3d> polygon)
      : points_(flattened(polygon)), left_(polygon.size()), corners_(polygon.size()) {
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < n; ++i) corners_[i] = {.before = (i + n - 1) % n, .after = (i + 1) % n};
    for (std::size_t i = 0; i < n; ++i) judge(i);
  }

  std::vector<std::array<std::size_t, 3>> cut() {
    std::vector<std::array<std::size_t, 3>> triangles;
    triangles.reserve(left_ - 2);
    // From corner 1 on, so that a convex polygon becomes the usual fan around corner 0.
    queue_all(1);
    while (left_ > 3) triangles.push_back(remove(next_ear()));
    const std::size_t a = first_;
    triangles.push_back({a, corners_[a].after, corners_[a].before});
    return triangles;
  }

 private:
  struct Corner {
    std::size_t before, after;
    bool convex = false, queued = false, gone = false;
  };

  void judge(std::size_t i) {
    Corner& corner = corners_[i];
    corner.convex = turn(points_[corner.before], points_[i], points_[corner.after]) > 0;
    if (!corner.convex) not_convex_.push_back(i);
  }

  void queue(std::size_t i) {
    if (!corners_[i].queued) queue_.push_back(i);
    corners_[i].queued = true;
  }

  void queue_all(std::size_t begin) {
    std::size_t i = begin;
    do {
      queue(i);
      i = corners_[i].after;
    } while (i != begin);
  }

  std::size_t next_ear() {
    // What floating point hid may show after other cuts. A polygon that crosses itself may have no ear at
    // all.
    for (;;) {
      while (!queue_.empty()) {
        const std::size_t i = queue_.front();
        queue_.pop_front();
        corners_[i].queued = false;
        if (!corners_[i].gone && is_ear(i)) return i;
      }
      if (rescans_ == 8) return corners_[first_].after;
      ++rescans_;
      queue_all(corners_[first_].after);
    }
  }

  bool is_ear(std::size_t at) {
    if (!corners_[at].convex) return false;
    const Point& a = points_[corners_[at].before];
    const Point& b = points_[at];
    const Point& c = points_[corners_[at].after];
    std::erase_if(not_convex_, [this](std::size_t i) { return corners_[i].gone || corners_[i].convex; });
    for (const std::size_t i : not_convex_) {
      const Point& p = points_[i];
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  std::array<std::size_t, 3> remove(std::size_t i) {
    const std::size_t before = corners_[i].before;
    const std::size_t after = corners_[i].after;
    corners_[i].gone = true;
    corners_[before].after = after;
    corners_[after].before = before;
    if (first_ == i) first_ = after;
    --left_;
    for (const std::size_t neighbour : {after, before}) {
      const bool was_convex = corners_[neighbour].convex;
      judge(neighbour);
      if (!was_convex && !corners_[neighbour].convex) not_convex_.pop_back();
      queue(neighbour);
    }
    return {before, i, after};
  }

  std::vector<Point> points_;
  std::size_t left_, first_ = 0;
  std::vector<Corner> corners_;
  std::vector<std::size_t> not_convex_;
  std::deque<std::size_t> queue_;
  int rescans_ = 0;
};

}  // namespace

std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec3d> polygon) {
  if (polygon.size() < 3) return {};
  if (polygon.size() == 3) return {{0, 1, 2}};
  return EarClipping(polygon).cut();
}

}  // namespace gabarit
