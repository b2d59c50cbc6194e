#include "checks/distinct_segments.h"

#include <bit>

namespace gabarit {
namespace {

// From the end with the smaller x, or the smaller y. -0 becomes 0.
Segment2 directed(const PlanSide& side) {
  const Point2 a = side.from + Point2{0, 0};
  const Point2 b = side.to + Point2{0, 0};
  return b.x < a.x || (b.x == a.x && b.y < a.y) ? Segment2{b, a} : Segment2{a, b};
}

std::size_t hash(const Segment2& s) {
  std::uint64_t h = 0;
  for (const double x : {s.from.x, s.from.y, s.to.x, s.to.y})
    h = (std::rotl(h, 29) ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15ULL;
  return h ^ (h >> 32U);
}

}  // namespace

DistinctSegments distinct_segments(const std::vector<PlanSide>& sides) {
  DistinctSegments out;
  out.number.reserve(sides.size());
  // Open addressing; number + 1, 0 is free.
  std::vector<std::uint32_t> slots(std::bit_ceil(std::max<std::size_t>(16, sides.size() * 2)), 0);
  for (const PlanSide& side : sides) {
    const Segment2 segment = directed(side);
    std::size_t slot = hash(segment) & (slots.size() - 1);
    const auto same = [&](std::uint32_t i) {
      return out.segments[i].from == segment.from && out.segments[i].to == segment.to;
    };
    while (slots[slot] != 0 && !same(slots[slot] - 1)) slot = (slot + 1) & (slots.size() - 1);
    if (slots[slot] == 0) {
      out.segments.push_back(segment);
      slots[slot] = static_cast<std::uint32_t>(out.segments.size());
    }
    out.number.push_back(slots[slot] - 1);
  }
  return out;
}

}  // namespace gabarit
