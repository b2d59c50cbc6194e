#include "checks/contact_depth.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "gpu/parallel_for.h"

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

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void lower(float& place, float value) {
  const std::atomic_ref<float> shared(place);
  float now = shared.load(std::memory_order_relaxed);
  while (value < now && !shared.compare_exchange_weak(now, value, std::memory_order_relaxed)) {
  }
}

// The half width at height y of a disk whose middle is at height 0; negative where there is none.
double half_width(double radius, double y) {
  return std::abs(y) < radius ? std::sqrt((radius - y) * (radius + y)) : -1;
}

// Where in a row of squares a disk may touch that rolls along a segment: it holds nothing, so the squares
// inside it need not be looked at.
struct Rim {
  Segment2 centre;
  double inner, outer;  // radii

  template <class Add>
  void spans(double bottom, double top, Add&& add) const {
    const auto [low_y, high_y] = std::minmax(centre.from.y, centre.to.y);
    const auto [low_x, high_x] = std::minmax(centre.from.x, centre.to.x);
    const double half = half_width(outer, std::max({0.0, bottom - high_y, low_y - top}));
    if (half < 0) return;
    double hole_from = high_x + half;
    double hole_to = low_x - half;
    for (const Point2 c : {centre.from, centre.to}) {
      const double empty = half_width(inner, std::max(std::abs(bottom - c.y), std::abs(top - c.y)));
      if (empty < 0) continue;
      hole_from = std::min(hole_from, c.x - empty);
      hole_to = std::max(hole_to, c.x + empty);
    }
    if (hole_from >= hole_to) return add(low_x - half, high_x + half);
    add(low_x - half, hole_from);
    add(hole_to, high_x + half);
  }
};

template <class Visit>
void visit_near(const SegmentGrid& grid, const Segment2& centre, double radius, double reach, Visit&& visit) {
  const Rim rim{centre, radius * (1 - 1e-6), reach + 1e-6 * grid.size()};
  const auto [low, high] = std::minmax(centre.from.y, centre.to.y);
  grid.visit_rows(
      low - rim.outer, high + rim.outer,
      [&](double bottom, double top, auto&& add) { rim.spans(bottom, top, add); }, visit);
}

Point2 nearest_point(Point2 p, const Segment2& s) {
  const Point2 along = s.to - s.from;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - s.from, along) / squared, 0.0, 1.0) : 0.0;
  return s.from + along * t;
}

double nearest_ends(const Segment2& s, const Segment2& t) {
  const auto squared = [](Point2 p, Point2 q) { return dot(p - q, p - q); };
  return std::min(std::min(squared(s.from, t.from), squared(s.from, t.to)),
                  std::min(squared(s.to, t.from), squared(s.to, t.to)));
}

// Infinite where it is certainly more than `most`: the squared distance falls short of that between the
// nearest ends by no more than the square of half of both lengths.
double side_distance(const Segment2& centre, double size, const Segment2& side, double most) {
  const double ends = nearest_ends(centre, side);
  const double halves = (size + length(side.to - side.from)) / 2;
  if (ends - halves * halves > most * most * (1 + 1e-9)) return infinity;
  return segment_distance(centre.from, centre.to, side.from, side.to);
}

struct LowerDepths {
  const SegmentGrid& grid;
  const std::vector<Segment2>& sides;
  const std::vector<Segment2>& centres;
  double radius, reach;
  std::vector<float>& depth;

  void operator()(std::int64_t i) const {
    const Segment2& centre = centres[static_cast<std::size_t>(i)];
    const double size = length(centre.to - centre.from);
    visit_near(grid, centre, radius, reach, [&](std::uint32_t side) {
      const double d = side_distance(centre, size, sides[side], reach);
      if (d <= reach) lower(depth[side], static_cast<float>(d - radius));
    });
  }
};

// How much nearer to something than from a known place of the path others can be that lie within `apart` of
// it. They keep out of what is touched there: of their way at most `inwards` leads towards it.
struct Gain {
  Point2 touched;  // unit vector
  double apart, inwards;

  // `towards`: unit vector. A distance shrinks no faster than by the way in its own direction.
  double operator()(Point2 towards) const {
    const double ahead = dot(towards, touched);
    if (ahead < 0) return apart;
    return std::min(apart, inwards * ahead + apart * std::abs(cross(towards, touched)));
  }
};

struct LowerDepthsAround {
  const SegmentGrid& grid;
  const std::vector<Segment2>& sides;
  const std::vector<Segment2>& places;  // of no length
  double radius, tolerance, apart;
  std::vector<float>& depth;

  void operator()(std::int64_t i) const {
    const Segment2& place = places[static_cast<std::size_t>(i)];
    const double reach = radius + tolerance + apart;
    Point2 nearest;
    double least = infinity;
    visit_near(grid, place, radius, reach, [&](std::uint32_t side) {
      const Point2 way = nearest_point(place.from, sides[side]) - place.from;
      if (const double d = length(way); d < least) least = d, nearest = way;
    });
    if (!(least < infinity)) return;
    // A hair for the rounding of the place.
    const Gain gain{nearest * (1 / least), apart, apart * apart / (2 * radius) + 1e-6 * radius};
    visit_near(grid, place, radius, reach, [&](std::uint32_t side) {
      const Point2 way = nearest_point(place.from, sides[side]) - place.from;
      const double d = length(way);
      if (d <= reach && d - gain(way * (1 / d)) <= radius + tolerance)
        lower(depth[side], static_cast<float>(d - radius));
    });
  }
};

}  // namespace

ContactDepth::ContactDepth(const std::vector<PlanSide>& sides, double radius)
    : sides_(distinct_segments(sides)), grid_(sides_.segments, radius / 64) {}

std::vector<float> ContactDepth::along(const DiskPath& path, double tolerance, const Device& device,
                                       double apart) const {
  std::vector<float> depth(sides_.segments.size(), std::numeric_limits<float>::infinity());
  const std::vector<Segment2> middles = centres(path);
  const auto n = static_cast<std::int64_t>(middles.size());
  const std::vector<Segment2>& sides = sides_.segments;
  if (apart > 0) {
    parallel_for_cpu(device, n,
                     LowerDepthsAround{grid_, sides, middles, path.radius, tolerance, apart, depth}, 16);
  } else {
    parallel_for_cpu(device, n,
                     LowerDepths{grid_, sides, middles, path.radius, path.radius + tolerance, depth}, 16);
  }
  std::vector<float> by_side;
  by_side.reserve(sides_.number.size());
  for (const std::uint32_t i : sides_.number) by_side.push_back(depth[i]);
  return by_side;
}

}  // namespace gabarit
