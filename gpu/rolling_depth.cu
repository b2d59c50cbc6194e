#include <limits>

#include "gpu/atomic.h"
#include "gpu/parallel_for.h"
#include "gpu/rolling_depth.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

GABARIT_HD double lesser(double a, double b) { return b < a ? b : a; }
GABARIT_HD double greater(double a, double b) { return a < b ? b : a; }

// The half width at height y of a disk whose middle is at height 0; negative where there is none.
GABARIT_HD double half_width(double radius, double y) {
  return std::abs(y) < radius ? std::sqrt((radius - y) * (radius + y)) : -1;
}

// Where in a row of squares a disk may touch that rolls along a segment: it holds nothing, so the squares
// inside it need not be looked at.
struct Rim {
  Segment2 centre;
  double inner, outer;  // radii

  template <class Add>
  GABARIT_HD void spans(double bottom, double top, Add&& add) const {
    const double low_x = lesser(centre.from.x, centre.to.x), high_x = greater(centre.from.x, centre.to.x);
    const double low_y = lesser(centre.from.y, centre.to.y), high_y = greater(centre.from.y, centre.to.y);
    const double half = half_width(outer, greater(0.0, greater(bottom - high_y, low_y - top)));
    if (half < 0) return;
    double hole_from = high_x + half;
    double hole_to = low_x - half;
    for (int end = 0; end < 2; ++end) {
      const Point2 c = end == 0 ? centre.from : centre.to;
      const double empty = half_width(inner, greater(std::abs(bottom - c.y), std::abs(top - c.y)));
      if (empty < 0) continue;
      hole_from = lesser(hole_from, c.x - empty);
      hole_to = greater(hole_to, c.x + empty);
    }
    if (hole_from >= hole_to) return add(low_x - half, high_x + half);
    add(low_x - half, hole_from);
    add(hole_to, high_x + half);
  }
};

// The rows of squares around a centre that one index of a kernel looks at.
struct Slice {
  std::int64_t number = 0, of = 1;
};

template <class Visit>
GABARIT_HD void visit_near(const SegmentSquares& squares, const Segment2& centre, double radius, double reach,
                           Slice slice, Visit&& visit) {
  const Rim rim{centre, radius * (1 - 1e-6), reach + 1e-6 * squares.squares.size};
  squares.visit_rows(
      lesser(centre.from.y, centre.to.y) - rim.outer, greater(centre.from.y, centre.to.y) + rim.outer,
      slice.number, slice.of, [&](double bottom, double top, auto&& add) { rim.spans(bottom, top, add); },
      visit);
}

GABARIT_HD double nearest_ends(const Segment2& s, const Segment2& t) {
  const auto squared = [](Point2 p, Point2 q) { return dot(p - q, p - q); };
  return lesser(lesser(squared(s.from, t.from), squared(s.from, t.to)),
                lesser(squared(s.to, t.from), squared(s.to, t.to)));
}

// Infinite where it is certainly more than `most`: the squared distance falls short of that between the
// nearest ends by no more than the square of half of both lengths.
GABARIT_HD double side_distance(const Segment2& centre, double size, const Segment2& side, double most) {
  const double ends = nearest_ends(centre, side);
  const double halves = (size + length(side.to - side.from)) / 2;
  if (ends - halves * halves > most * most * (1 + 1e-9)) return infinity;
  return segment_distance(centre.from, centre.to, side.from, side.to);
}

GABARIT_HD void lower(std::uint32_t& depth, double value) {
  lower_shared(depth, ordered(static_cast<float>(value)));
}

struct LowerDepths {
  SegmentSquares squares;
  View<const Segment2> sides, centres;
  double radius, reach;
  std::int64_t slices;
  View<std::uint32_t> depth;

  GABARIT_HD void operator()(std::int64_t i) const {
    const Segment2 centre = centres[i / slices];
    const double size = length(centre.to - centre.from);
    visit_near(squares, centre, radius, reach, {i % slices, slices}, [&](std::uint32_t side) {
      const double d = side_distance(centre, size, sides[side], reach);
      if (d <= reach) lower(depth[side], d - radius);
    });
  }
};

// How much nearer to something than from a known place of the path others can be that lie within `apart` of
// it. They keep out of what is touched there: of their way at most `inwards` leads towards it.
struct Gain {
  Point2 touched;  // unit vector
  double apart, inwards;

  // `towards`: unit vector. A distance shrinks no faster than by the way in its own direction.
  GABARIT_HD double operator()(Point2 towards) const {
    const double ahead = dot(towards, touched);
    if (ahead < 0) return apart;
    return lesser(apart, inwards * ahead + apart * std::abs(cross(towards, touched)));
  }
};

struct LowerDepthsAround {
  SegmentSquares squares;
  View<const Segment2> sides, places;
  RollingDisk disk;
  View<std::uint32_t> depth;

  GABARIT_HD void operator()(std::int64_t i) const {
    const Segment2 place = places[i];
    const double most = disk.radius + disk.tolerance;
    const double reach = most + disk.apart;
    Point2 nearest;
    double least = infinity;
    visit_near(squares, place, disk.radius, reach, {}, [&](std::uint32_t side) {
      const Point2 way = nearest_point(place.from, sides[side]) - place.from;
      if (const double d = length(way); d < least) least = d, nearest = way;
    });
    if (!(least < infinity)) return;
    // A hair for the rounding of the place.
    const double inwards = disk.apart * disk.apart / (2 * disk.radius) + 1e-6 * disk.radius;
    const Gain gain{nearest * (1 / least), disk.apart, inwards};
    visit_near(squares, place, disk.radius, reach, {}, [&](std::uint32_t side) {
      const Point2 way = nearest_point(place.from, sides[side]) - place.from;
      const double d = length(way);
      if (d <= reach && d - gain(way * (1 / d)) <= most) lower(depth[side], d - disk.radius);
    });
  }
};

}  // namespace

RollingDepth::RollingDepth(const Device& device, const SegmentSquares& squares,
                           std::span<const Segment2> segments)
    : device_(device), squares_(squares), segments_(gabarit::view(segments)) {
  if (!device.has_own_memory()) return;
  const auto span = [](const View<const std::uint32_t>& all) {
    return std::span(all.data, static_cast<std::size_t>(all.size));
  };
  first_ = Buffer<std::uint32_t>(device, span(squares.first));
  numbers_ = Buffer<std::uint32_t>(device, span(squares.numbers));
  kept_ = Buffer<Segment2>(device, segments);
  squares_.first = std::as_const(first_).view();
  squares_.numbers = std::as_const(numbers_).view();
  segments_ = std::as_const(kept_).view();
}

std::vector<float> RollingDepth::along(std::span<const Segment2> centres, const RollingDisk& disk) const {
  const auto n = static_cast<std::int64_t>(centres.size());
  const Buffer<Segment2> path(device_, centres);
  Buffer<std::uint32_t> lowest(device_,
                               std::vector<std::uint32_t>(static_cast<std::size_t>(segments_.size),
                                                          ordered(std::numeric_limits<float>::infinity())));
  if (disk.apart > 0) {
    parallel_for(device_, n, LowerDepthsAround{squares_, segments_, path.view(), disk, lowest.view()}, 16);
  } else {
    // A warp of a GPU shares a centre: its threads look at rows side by side.
    const std::int64_t slices = device_.has_own_memory() ? 32 : 1;
    parallel_for(device_, n * slices,
                 LowerDepths{squares_, segments_, path.view(), disk.radius, disk.radius + disk.tolerance,
                             slices, lowest.view()},
                 16 * slices);
  }
  std::vector<float> depth;
  depth.reserve(static_cast<std::size_t>(segments_.size));
  for (const std::uint32_t order : std::move(lowest).read()) depth.push_back(from_ordered(order));
  return depth;
}

}  // namespace gabarit
