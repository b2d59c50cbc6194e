// A grid over segments in the plane (points are segments of no length), each entered in the squares that it
// passes through.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "checks/plan.h"

namespace gabarit {

struct Segment2 {
  Point2 from, to;
};

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
  SegmentGrid(const std::vector<Segment2>& segments, double size);

  // Visits the numbers of the segments in the squares within `reach` of the box [low, high] along each axis,
  // a segment once a square. wanted(low, high of the square) is asked before each square that holds any.
  template <class Wanted, class Visit>
  void visit(Point2 low, Point2 high, double reach, Wanted&& wanted, Visit&& visit) const {
    for (std::size_t y = row(low.y - reach); y <= row(high.y + reach); ++y) {
      for (std::size_t x = column(low.x - reach); x <= column(high.x + reach); ++x) {
        const std::size_t square = y * columns_ + x;
        if (first_[square] == first_[square + 1]) continue;
        const Point2 corner =
            origin_ + Point2{static_cast<double>(x) * size_, static_cast<double>(y) * size_};
        if (!wanted(corner, corner + Point2{size_, size_})) continue;
        for (std::uint32_t i = first_[square]; i < first_[square + 1]; ++i) visit(numbers_[i]);
      }
    }
  }

  // Visits the numbers in the squares that a shape touches, a segment once a square. For each row of squares
  // between `low` and `high`, spans(bottom, top, add) calls add(from, to) for every range of x of interest.
  template <class Spans, class Visit>
  void visit_rows(double low, double high, Spans&& spans, Visit&& visit) const {
    for (std::size_t y = row(low); y <= row(high); ++y) {
      const double bottom = origin_.y + static_cast<double>(y) * size_;
      spans(bottom, bottom + size_, [&](double from, double to) {
        if (!(from <= to)) return;
        const std::uint32_t end = first_[y * columns_ + column(to) + 1];
        for (std::uint32_t i = first_[y * columns_ + column(from)]; i < end; ++i) visit(numbers_[i]);
      });
    }
  }
  double size() const { return size_; }

 private:
  template <class Use>
  void for_each_square(const Segment2& s, Use&& use) const;
  std::size_t column(double x) const { return place((x - origin_.x) / size_, columns_); }
  std::size_t row(double y) const { return place((y - origin_.y) / size_, rows_); }
  static std::size_t place(double at, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
  }

  Point2 origin_;
  double size_ = 1;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> first_, numbers_;
};

}  // namespace gabarit
