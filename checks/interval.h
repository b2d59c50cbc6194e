// A closed range of heights or values.
#pragma once

#include <algorithm>
#include <limits>

namespace gabarit {

struct Interval {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();

  bool empty() const { return !(from <= to); }
  bool contains(double x) const { return from <= x && x <= to; }
};

inline Interval intersection(const Interval& a, const Interval& b) {
  return {std::max(a.from, b.from), std::min(a.to, b.to)};
}

}  // namespace gabarit
