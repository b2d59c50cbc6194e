// A grid over segments in the plane (points are segments of no length), each entered in the squares that it
// passes through.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "gpu/segment_squares.h"

namespace gabarit {

struct Box2 {
  Point2 low{1e300, 1e300}, high{-1e300, -1e300};
  void add(Point2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

// Between the boxes [low, high] and b; 0 when they overlap.
inline double box_gap(Point2 low, Point2 high, const Box2& b) {
  const double x = std::max({0.0, b.low.x - high.x, low.x - b.high.x});
  const double y = std::max({0.0, b.low.y - high.y, low.y - b.high.y});
  return std::sqrt(x * x + y * y);
}

class SegmentGrid {
 public:
  // Squares of about `size`; larger where a side of the grid would have more than 2048 of them.
  SegmentGrid(std::span<const Segment2> segments, double size);

  // Visits the numbers of the segments in the squares within `reach` of the box [low, high] along each axis,
  // a segment once a square. wanted(low, high of the square) is asked before each square that holds any.
  template <class Wanted, class Visit>
  void visit(Point2 low, Point2 high, double reach, Wanted&& wanted, Visit&& visit) const {
    const std::int64_t last_column = squares_.column(high.x + reach), last_row = squares_.row(high.y + reach);
    for (std::int64_t y = squares_.row(low.y - reach); y <= last_row; ++y) {
      for (std::int64_t x = squares_.column(low.x - reach); x <= last_column; ++x) {
        const auto square = static_cast<std::size_t>(y * squares_.columns + x);
        if (first_[square] == first_[square + 1]) continue;
        const Point2 corner = squares_.origin + Point2{static_cast<double>(x) * squares_.size,
                                                       static_cast<double>(y) * squares_.size};
        if (!wanted(corner, corner + Point2{squares_.size, squares_.size})) continue;
        for (std::uint32_t i = first_[square]; i < first_[square + 1]; ++i) visit(numbers_[i]);
      }
    }
  }

  // Views of this.
  SegmentSquares lists() const { return {squares_, view(std::span(first_)), view(std::span(numbers_))}; }

 private:
  template <class Use>
  void for_each_square(const Segment2& s, Use&& use) const;

  Squares squares_;
  std::vector<std::uint32_t> first_, numbers_;
};

}  // namespace gabarit
