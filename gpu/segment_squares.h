// Segments in the plan, listed by the squares that they pass through; views of kernels.
#pragma once

#include <cstdint>

#include "gpu/segment2.h"
#include "gpu/view.h"

namespace gabarit {

struct Squares {
  Point2 origin;
  double size = 1;  // of a square, mm
  std::int64_t columns = 1, rows = 1;

  // Of the nearest square, for places outside.
  GABARIT_HD std::int64_t column(double x) const { return place((x - origin.x) / size, columns); }
  GABARIT_HD std::int64_t row(double y) const { return place((y - origin.y) / size, rows); }

 private:
  GABARIT_HD static std::int64_t place(double at, std::int64_t count) {
    const auto last = static_cast<double>(count - 1);
    return static_cast<std::int64_t>(at > 0 ? (at < last ? at : last) : 0.0);
  }
};

struct SegmentSquares {
  Squares squares;
  View<const std::uint32_t> first;    // by square, row by row, and the end
  View<const std::uint32_t> numbers;  // of segments

  // Visits the numbers in the squares that a shape touches, a segment once a square, in every so many rows
  // (`stride`, beginning at number `slice`) of those between `low` and `high`. spans(bottom, top, add) calls
  // add(from, to) for every range of x of interest in a row.
  template <class Spans, class Visit>
  GABARIT_HD void visit_rows(double low, double high, std::int64_t slice, std::int64_t stride, Spans&& spans,
                             Visit&& visit) const {
    const std::int64_t last = squares.row(high);
    for (std::int64_t y = squares.row(low) + slice; y <= last; y += stride) {
      const double bottom = squares.origin.y + static_cast<double>(y) * squares.size;
      spans(bottom, bottom + squares.size, [&](double from, double to) {
        if (!(from <= to)) return;
        const std::int64_t row = y * squares.columns;
        const std::uint32_t end = first[row + squares.column(to) + 1];
        for (std::uint32_t i = first[row + squares.column(from)]; i < end; ++i) visit(numbers[i]);
      });
    }
  }
};

}  // namespace gabarit
