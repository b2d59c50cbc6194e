#include "gpu/segment_grid.h"

namespace gabarit {

// Column by column, in each the rows between the places where the segment enters and leaves it, and a little
// more against rounding.
template <class Use>
void SegmentGrid::for_each_square(const Segment2& s, Use&& use) const {
  const bool ahead = s.from.x <= s.to.x;
  const Point2 a = ahead ? s.from : s.to;
  const Point2 b = ahead ? s.to : s.from;
  const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
  const double size = squares_.size;
  const double slack = 1e-6 * size;
  const std::int64_t last = squares_.column(b.x);
  for (std::int64_t x = squares_.column(a.x); x <= last; ++x) {
    const double left = squares_.origin.x + static_cast<double>(x) * size;
    const double enter = a.x >= left ? a.y : a.y + (left - a.x) * slope;
    const double leave = b.x <= left + size ? b.y : a.y + (left + size - a.x) * slope;
    const std::int64_t top = squares_.row(std::max(enter, leave) + slack);
    for (std::int64_t y = squares_.row(std::min(enter, leave) - slack); y <= top; ++y)
      use(static_cast<std::size_t>(y * squares_.columns + x));
  }
}

SegmentGrid::SegmentGrid(std::span<const Segment2> segments, double size) {
  Box2 box;
  for (const Segment2& s : segments) {
    box.add(s.from);
    box.add(s.to);
  }
  const Point2 extent = segments.empty() ? Point2{} : box.high - box.low;
  squares_.origin = segments.empty() ? Point2{} : box.low;
  squares_.size = std::max({size, extent.x / 2048, extent.y / 2048, 1e-9});
  squares_.columns = static_cast<std::int64_t>(extent.x / squares_.size) + 1;
  squares_.rows = static_cast<std::int64_t>(extent.y / squares_.size) + 1;
  first_.assign(static_cast<std::size_t>(squares_.columns * squares_.rows) + 1, 0);
  for (const Segment2& s : segments) for_each_square(s, [&](std::size_t square) { ++first_[square + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  numbers_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    for_each_square(segments[i], [&](std::size_t square) { numbers_[next[square]++] = i; });
  }
}

}  // namespace gabarit
