#include "checks/segment_grid.h"

namespace gabarit {

// A segment passes a square only if it comes within half a diagonal of its middle.
template <class Use>
void SegmentGrid::for_each_square(const Segment2& s, Use&& use) const {
  const std::size_t left = column(std::min(s.from.x, s.to.x));
  const std::size_t right = column(std::max(s.from.x, s.to.x));
  const std::size_t bottom = row(std::min(s.from.y, s.to.y));
  const std::size_t top = row(std::max(s.from.y, s.to.y));
  for (std::size_t y = bottom; y <= top; ++y) {
    for (std::size_t x = left; x <= right; ++x) {
      const Point2 middle =
          origin_ + Point2{(static_cast<double>(x) + 0.5) * size_, (static_cast<double>(y) + 0.5) * size_};
      const bool narrow = left == right || bottom == top;
      if (narrow || point_segment_distance(middle, s.from, s.to) <= 0.7072 * size_) use(y * columns_ + x);
    }
  }
}

SegmentGrid::SegmentGrid(const std::vector<Segment2>& segments, double size) {
  Box2 box;
  for (const Segment2& s : segments) {
    box.add(s.from);
    box.add(s.to);
  }
  const Point2 extent = segments.empty() ? Point2{} : box.high - box.low;
  origin_ = segments.empty() ? Point2{} : box.low;
  size_ = std::max({size, extent.x / 2048, extent.y / 2048, 1e-9});
  columns_ = static_cast<std::size_t>(extent.x / size_) + 1;
  rows_ = static_cast<std::size_t>(extent.y / size_) + 1;
  first_.assign(columns_ * rows_ + 1, 0);
  for (const Segment2& s : segments) for_each_square(s, [&](std::size_t square) { ++first_[square + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  numbers_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    for_each_square(segments[i], [&](std::size_t square) { numbers_[next[square]++] = i; });
  }
}

}  // namespace gabarit
