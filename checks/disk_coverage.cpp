#include "checks/disk_coverage.h"

#include <algorithm>
#include <numbers>

#include "checks/certified.h"

namespace gabarit {
namespace {

constexpr double pi = std::numbers::pi;

// A direction and its left normal, with the length of the edge.
struct Line {
  Point2 origin, along, normal;
  double length;
};

Line line_of(const OutlineFeatures& outline, std::uint32_t edge) {
  const auto [a, b] = outline.edges[edge];
  const Point2 p = outline.points[a];
  const Point2 d = outline.points[b] - p;
  const double l = length(d);
  const Point2 along = d * (1 / l);
  return {p, along, {-along.y, along.x}, l};
}

// Takes the open arc from `from` to `to` (to >= from, any turn of the circle) out of free angles in [0, 2
// pi].
void take_arc(FreeIntervals& free, double from, double to) {
  if (to - from >= 2 * pi) return free.take_out(-1, 7);
  const double turns = std::floor(from / (2 * pi));
  from -= turns * 2 * pi;
  to -= turns * 2 * pi;
  free.take_out(from, std::min(to, 2 * pi + 1));
  if (to > 2 * pi) free.take_out(-1, to - 2 * pi);
}

// A disk that touches v overlaps w in the directions within acos(|vw| / 2R) of w.
void point_covers_circle(Point2 v, Point2 w, double r, FreeIntervals& free) {
  if (compare_distance(v, w, 2 * r) >= 0) return;
  const Point2 d = w - v;
  const double l = length(d);
  const double half = std::atan2(std::sqrt(std::max(0.0, (2 * r - l) * (2 * r + l))), l);
  const double towards = std::atan2(d.y, d.x);
  take_arc(free, towards - half, towards + half);
}

// The points of the circle that lie beside the edge and nearer than R to its line. The edge's ends have
// circles of their own.
void edge_covers_circle(Point2 v, const Line& e, Point2 a, Point2 b, double r, FreeIntervals& free) {
  const double t = dot(v - e.origin, e.along);
  double s = dot(v - e.origin, e.normal);
  if (t + r <= 0 || t - r >= e.length) return;
  if (v == a || v == b) s = 0;
  if (std::abs(s) > 1.99 * r && compare_line_distance(v, a, b, 2 * r) >= 0) return;
  const double side = s < 0 ? -1 : 1;
  s = std::abs(s);
  if (s >= 2 * r) return;
  const double turn = std::atan2(e.along.y, e.along.x);
  // With u the direction of the centre, at an angle phi from the edge: the disk overlaps the line where
  // sin(phi) < (R - s) / R, and its centre stands over the edge where begin < |phi| < end.
  const double away = std::atan2(r - s, std::sqrt(s * (2 * r - s)));
  const double begin = e.length - t >= r ? 0 : std::acos(std::clamp((e.length - t) / r, -1.0, 1.0));
  const double end = t >= r ? pi : std::acos(std::clamp(-t / r, -1.0, 1.0));
  const auto take = [&](double from, double to) {
    if (from < to) side > 0 ? take_arc(free, turn + from, turn + to) : take_arc(free, turn - to, turn - from);
  };
  take(begin, std::min(end, away));
  take(std::max(begin, pi - away), end);
  if (s == 0) {  // both halves of the circle are alike
    take(-std::min(end, away), -begin);
    take(-end, -std::max(begin, pi - away));
  } else {
    const double level = std::min(0.0, away);
    take(std::max(-end, -pi - level), std::min(-begin, level));
  }
}

// Takes out of the line c(t) = from + t * along what is nearer than R to w.
void point_covers_line(const Line& c, double sign, Point2 w, Point2 a, Point2 b, double r,
                       FreeIntervals& free) {
  if (w == a || w == b) return;
  const double t = dot(w - c.origin, c.along);
  if (t + r <= 0 || t - r >= c.length) return;
  const double s = sign * dot(w - c.origin, c.normal);
  if (s <= 0 || s >= 2 * r) return;
  if (s > 1.99 * r && compare_line_distance(w, a, b, 2 * r) >= 0) return;
  if (s < 0.01 * r && side_of_line(a, b, w) == 0) return;
  const double h = std::sqrt(s * (2 * r - s));
  free.take_out(t - h, t + h);
}

// Distances (mm) nearer than this are one: two lines that lie so near to each other must not both be covered
// by the other.
constexpr double same_line = 1e-10;

struct Slab {
  double from = -1e300, to = 1e300;
  // Keeps t with low < value + t * slope < high.
  void cut(double value, double slope, double low, double high) {
    if (std::abs(slope) < 1e-12) {
      if (value <= low + same_line || value >= high - same_line) to = from;
      return;
    }
    const double t0 = (low - value) / slope;
    const double t1 = (high - value) / slope;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
  }
};

void edge_covers_line(const Line& c, double sign, Point2 a, Point2 b, const Line& e, Point2 p, Point2 q,
                      double r, FreeIntervals& free) {
  const Point2 start = c.origin + c.normal * (sign * r);
  Slab slab;
  slab.cut(dot(start - e.origin, e.along), dot(c.along, e.along), 0, e.length);
  if (!(slab.from < slab.to)) return;
  const double slope = dot(c.along, e.normal);
  if (std::abs(slope) < 1e-12) {
    // Parallel: room for the disk between the lines is decided exactly.
    const double s = sign * dot(p - c.origin, c.normal);
    if (s <= same_line || s >= 2 * r * (1 + 1e-9)) return;
    if (s > 1.99 * r && compare_line_distance(p, a, b, 2 * r) >= 0 &&
        compare_line_distance(q, a, b, 2 * r) >= 0)
      return;
  } else {
    slab.cut(dot(start - e.origin, e.normal), slope, same_line - r, r - same_line);
  }
  free.take_out(slab.from, slab.to);
}

// Takes out of [from, to] what the disk cannot get to anyway; `speed` is how fast the centre moves along the
// parameter.
template <class Position>
void keep_reachable(const ReachGrid* reach, FreeIntervals& free, double from, double to, double speed,
                    Position&& position) {
  if (reach == nullptr) return;
  const double stride = reach->spacing() / 2;
  const int steps = 1 + static_cast<int>((to - from) * speed / stride);
  const double step = (to - from) / steps;
  for (int i = 0; i < steps;) {
    // As far as no axis can be, the samples in between need not be asked.
    const int begin = i;
    for (double gap = 1; i < steps; i += 1 + static_cast<int>(gap / stride)) {
      gap = reach->axis_gap(position(from + (i + 0.5) * step));
      if (gap <= 0) break;
    }
    i = std::min(i, steps);
    // The ends of the parameter are no cuts.
    if (i > begin)
      free.take_out(begin == 0 ? from - 1 : from + begin * step, i == steps ? to + 1 : from + i * step);
    ++i;
  }
}

// Covers a curve by what is near its own feature first, then by what is within R of the centres that are
// left.
template <class Position, class Cover>
void cover(const FeatureGrid& grid, Point2 low, Point2 high, FreeIntervals& free, double step,
           Position&& position, Cover&& cover_by) {
  const double r = grid.radius();
  if (free.empty()) return;
  grid.squares().visit(
      low, high, 0, [&](Point2, Point2) { return !free.empty(); }, cover_by);
  if (free.empty()) return;
  const auto centres_left = [&] {
    Box2 left;
    for (const auto& [from, to] : free.ranges()) {
      const int steps = 1 + static_cast<int>((to - from) / step);
      for (int i = 0; i <= steps; ++i) left.add(position(from + (to - from) * i / steps));
    }
    // Between samples an arc bulges by less than this.
    const double bulge = r * step * step / 8;
    left.low = left.low - Point2{bulge, bulge};
    left.high = left.high + Point2{bulge, bulge};
    return left;
  };
  Box2 left = centres_left();
  int changes = free.changes();
  const auto wanted = [&](Point2 a, Point2 b) {
    if (free.empty()) return false;
    if (changes != free.changes()) left = centres_left();
    changes = free.changes();
    return box_gap(a, b, left) <= r;
  };
  const Box2 whole = left;
  grid.squares().visit(whole.low, whole.high, r, wanted, cover_by);
}

// A piece is cut when it ends where an interval of the reachable parameters did, not where another feature
// begins.
bool is_cut(const FreeIntervals& reachable, double from, double to, double first, double last) {
  for (const auto& range : reachable.ranges()) {
    if ((range.from == from && from > first) || (range.to == to && to < last)) return true;
  }
  return false;
}

}  // namespace

static std::vector<Segment2> segments_of(const OutlineFeatures& outline) {
  std::vector<Segment2> segments;
  segments.reserve(outline.points.size() + outline.edges.size());
  for (const Point2 p : outline.points) segments.push_back({p, p});
  for (const auto& [a, b] : outline.edges) segments.push_back({outline.points[a], outline.points[b]});
  return segments;
}

FeatureGrid::FeatureGrid(const OutlineFeatures& outline, double radius, const ReachGrid* reach)
    : outline_(&outline), radius_(radius), reach_(reach), squares_(segments_of(outline), radius / 16) {}

void free_arcs(const FeatureGrid& grid, std::uint32_t point, std::vector<PathPiece>& out) {
  const OutlineFeatures& outline = grid.outline();
  const double r = grid.radius();
  const Point2 v = outline.points[point];
  FreeIntervals free(0, 2 * pi);
  free.least = 1e-11;
  const auto points = static_cast<std::uint32_t>(outline.points.size());
  const auto position = [&](double angle) { return v + Point2{std::cos(angle), std::sin(angle)} * r; };
  keep_reachable(grid.reach(), free, 0, 2 * pi, r, position);
  const FreeIntervals reachable = free;
  cover(grid, v, v, free, 0.1, position, [&](std::uint32_t feature) {
    if (feature == point || free.empty()) return;
    if (feature < points) {
      point_covers_circle(v, outline.points[feature], r, free);
    } else {
      const auto [a, b] = outline.edges[feature - points];
      edge_covers_circle(v, line_of(outline, feature - points), outline.points[a], outline.points[b], r,
                         free);
    }
  });
  for (const auto& [from, to] : free.ranges()) {
    out.push_back({.from = position(from),
                   .to = position(to),
                   .centre = v,
                   .from_angle = from,
                   .to_angle = to,
                   .arc = true,
                   .foot = v,
                   .cut = is_cut(reachable, from, to, 0, 2 * pi)});
  }
}

void free_lines(const FeatureGrid& grid, std::uint32_t edge, std::vector<PathPiece>& out) {
  const OutlineFeatures& outline = grid.outline();
  const double r = grid.radius();
  const Line c = line_of(outline, edge);
  const Point2 a = outline.points[outline.edges[edge].first];
  const Point2 b = outline.points[outline.edges[edge].second];
  const auto points = static_cast<std::uint32_t>(outline.points.size());
  for (const double sign : {1.0, -1.0}) {
    if (sign * outline.area[edge] > 0) continue;
    FreeIntervals free(0, c.length);
    free.least = 1e-9;
    const auto position = [&](double t) { return c.origin + c.normal * (sign * r) + c.along * t; };
    keep_reachable(grid.reach(), free, 0, c.length, 1, position);
    const FreeIntervals reachable = free;
    const Point2 low{std::min(a.x, b.x), std::min(a.y, b.y)};
    const Point2 high{std::max(a.x, b.x), std::max(a.y, b.y)};
    cover(grid, low, high, free, c.length, position, [&](std::uint32_t feature) {
      if (feature == points + edge || free.empty()) return;
      if (feature < points) {
        point_covers_line(c, sign, outline.points[feature], a, b, r, free);
      } else {
        const auto [p, q] = outline.edges[feature - points];
        edge_covers_line(c, sign, a, b, line_of(outline, feature - points), outline.points[p],
                         outline.points[q], r, free);
      }
    });
    for (const auto& [from, to] : free.ranges()) {
      out.push_back({.from = position(from),
                     .to = position(to),
                     .centre = {},
                     .foot = c.origin + c.along * from,
                     .cut = is_cut(reachable, from, to, 0, c.length)});
    }
  }
}

}  // namespace gabarit
