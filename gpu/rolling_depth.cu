#include <algorithm>
#include <limits>
#include <optional>

#include "gpu/atomic.h"
#include "gpu/batches.h"
#include "gpu/buffer.h"
#include "gpu/parallel_for.h"
#include "gpu/rolling_depth.h"
#include "gpu/segment_grid.h"

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

// From a place to what it touches, or nearly.
struct Nearest {
  double distance = infinity;
  Point2 way;

  // Of several that are as near always the same one, whichever comes first.
  GABARIT_HD bool beyond(double other, Point2 to) const {
    if (other != distance) return other < distance;
    return to.x != way.x ? to.x < way.x : to.y < way.y;
  }
};

struct Around {
  SegmentSquares squares;
  View<const Segment2> sides, places;
  RollingDisk disk;

  GABARIT_HD double most() const { return disk.radius + disk.tolerance; }
  // Calls use(side, distance, way to it) for what may be near the place.
  template <class Use>
  GABARIT_HD void visit(std::int64_t place, Use&& use) const {
    const Segment2 at = places[place];
    visit_near(squares, at, disk.radius, most() + disk.apart, {}, [&](std::uint32_t side) {
      const Point2 way = nearest_point(at.from, sides[side]) - at.from;
      use(side, length(way), way);
    });
  }
};

struct FindNearest {
  Around around;
  View<Nearest> nearest;

  GABARIT_HD void operator()(std::int64_t i) const {
    Nearest best = nearest[i];
    around.visit(i, [&](std::uint32_t, double d, Point2 way) {
      if (best.beyond(d, way)) best = {d, way};
    });
    nearest[i] = best;
  }
};

struct LowerDepthsAround {
  Around around;
  View<const Nearest> nearest;
  View<std::uint32_t> depth;

  GABARIT_HD void operator()(std::int64_t i) const {
    if (!(nearest[i].distance < infinity)) return;
    const RollingDisk& disk = around.disk;
    // A hair for the rounding of the place.
    const double inwards = disk.apart * disk.apart / (2 * disk.radius) + 1e-6 * disk.radius;
    const Gain gain{nearest[i].way * (1 / nearest[i].distance), disk.apart, inwards};
    const double most = around.most();
    around.visit(i, [&](std::uint32_t side, double d, Point2 way) {
      if (d <= most + disk.apart && d - gain(way * (1 / d)) <= most) lower(depth[side], d - disk.radius);
    });
  }
};

// Copied to a device that has its own memory, else where they are.
template <class T>
class Kept {
 public:
  Kept(const Device& device, View<const T> all) : here_(all) {
    const std::span some(all.data, static_cast<std::size_t>(all.size));
    if (device.has_own_memory()) there_.emplace(device, some);
  }
  View<const T> view() const { return there_ ? there_->view() : here_; }
  std::size_t bytes() const { return there_ ? there_->bytes() : 0; }

 private:
  View<const T> here_;
  std::optional<const Buffer<T>> there_;
};

std::size_t index(std::int64_t i) { return static_cast<std::size_t>(i); }

// Calls work(begin, part of `centres` in the device's memory).
template <class Work>
void in_parts_of_path(const Device& device, std::span<const Segment2> centres, Work&& work) {
  constexpr std::int64_t few = 64;
  in_batches(static_cast<std::int64_t>(centres.size()), few, [&](std::int64_t begin, std::int64_t end) {
    const Buffer<Segment2> path(device, centres.subspan(index(begin), index(end - begin)));
    work(begin, path.view());
  });
}

}  // namespace

// Segments and the squares they lie in, in the memory of a device.
class SidesThere {
 public:
  // On a CPU both must outlive this.
  SidesThere(const Device& device, const SegmentSquares& squares, std::span<const Segment2> segments)
      : shape_(squares.squares),
        first_(device, squares.first),
        numbers_(device, squares.numbers),
        segments_(device, gabarit::view(segments)) {}

  SegmentSquares squares() const { return {shape_, first_.view(), numbers_.view()}; }
  View<const Segment2> segments() const { return segments_.view(); }
  std::size_t bytes() const { return first_.bytes() + numbers_.bytes() + segments_.bytes(); }

 private:
  Squares shape_;
  Kept<std::uint32_t> first_, numbers_;
  Kept<Segment2> segments_;
};

// As much again has to be free: what looks at them needs room too.
static std::shared_ptr<const SidesThere> all_there(const Device& device, const SegmentSquares& squares,
                                                   std::span<const Segment2> segments) {
  try {
    auto all = std::make_shared<const SidesThere>(device, squares, segments);
    if (device.has_own_memory()) static_cast<void>(DeviceMemory(device, all->bytes()));
    return all;
  } catch (const OutOfDeviceMemory&) {
    return nullptr;
  }
}

RollingDepth::RollingDepth(const Device& device, const SegmentSquares& squares,
                           std::span<const Segment2> segments)
    : device_(device),
      size_(squares.squares.size),
      segments_(segments),
      all_(all_there(device, squares, segments)) {}

// Squares no smaller than `least`, of which there are few for each segment.
static SegmentGrid grid_of_part(std::span<const Segment2> segments, double least) {
  Box2 box;
  for (const Segment2& s : segments) box.add(s.from), box.add(s.to);
  const Point2 extent = box.high - box.low;
  const double few = 2 * static_cast<double>(segments.size());
  return {segments, std::max({least, std::sqrt(extent.x * extent.y / few), extent.x / few, extent.y / few})};
}

// Calls work(sides, number of the first segment).
template <class Work>
void RollingDepth::in_parts(Work&& work) const {
  if (all_) return work(*all_, 0);
  constexpr std::int64_t few = 256;
  in_batches(static_cast<std::int64_t>(segments_.size()), few, [&](std::int64_t begin, std::int64_t end) {
    const auto part = segments_.subspan(index(begin), index(end - begin));
    const SegmentGrid grid = grid_of_part(part, size_);
    work(SidesThere(device_, grid.lists(), part), begin);
  });
}

static void find_nearest(const Device& device, const Around& around, std::span<Nearest> nearest) {
  Buffer<Nearest> there(device, std::span<const Nearest>(nearest));
  parallel_for(device, around.places.size, FindNearest{around, there.view()}, 16);
  there.read(nearest);
}

// `nearest`: to each place; not looked at when the path is all that is known.
static void lower_depths(const Device& device, const Around& around, std::span<const Nearest> nearest,
                         View<std::uint32_t> depth) {
  if (around.disk.apart > 0) {
    const Buffer<Nearest> known(device, nearest);
    parallel_for(device, around.places.size, LowerDepthsAround{around, known.view(), depth}, 16);
    return;
  }
  // A warp of a GPU shares a centre: its threads look at rows side by side.
  const std::int64_t slices = device.has_own_memory() ? 32 : 1;
  parallel_for(device, around.places.size * slices,
               LowerDepths{around.squares, around.sides, around.places, around.disk.radius, around.most(),
                           slices, depth},
               16 * slices);
}

std::vector<float> RollingDepth::along(std::span<const Segment2> centres, const RollingDisk& disk) const {
  std::vector<std::uint32_t> lowest(segments_.size(), ordered(std::numeric_limits<float>::infinity()));
  std::vector<Nearest> nearest(disk.apart > 0 ? centres.size() : 0);
  // Calls use(around, what is known to be nearest to its places) for parts of the path.
  const auto for_path = [&](const SidesThere& sides, auto&& use) {
    in_parts_of_path(device_, centres, [&](std::int64_t begin, View<const Segment2> path) {
      const auto known = std::span(nearest).subspan(nearest.empty() ? 0 : index(begin));
      use(Around{sides.squares(), sides.segments(), path, disk},
          known.first(nearest.empty() ? 0 : index(path.size)));
    });
  };
  if (disk.apart > 0) {
    in_parts([&](const SidesThere& sides, std::int64_t) {
      for_path(sides,
               [&](const Around& around, std::span<Nearest> some) { find_nearest(device_, around, some); });
    });
  }
  in_parts([&](const SidesThere& sides, std::int64_t first) {
    const auto part = std::span(lowest).subspan(index(first), index(sides.segments().size));
    Buffer<std::uint32_t> depth(device_, std::span<const std::uint32_t>(part));
    for_path(sides, [&](const Around& around, std::span<const Nearest> known) {
      lower_depths(device_, around, known, depth.view());
    });
    depth.read(part);
  });
  std::vector<float> depth;
  depth.reserve(lowest.size());
  for (const std::uint32_t order : lowest) depth.push_back(from_ordered(order));
  return depth;
}

}  // namespace gabarit
