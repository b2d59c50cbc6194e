#include "checks/free_intervals.h"

namespace gabarit {

void FreeIntervals::take_out(double from, double to) {
  if (!(from < to)) return;
  bool changes = false;
  for (const Range& r : ranges_) changes = changes || (from < r.to && to > r.from);
  if (!changes) return;
  ++changes_;
  std::vector<Range> left;
  const auto keep = [&](double a, double b) {
    if (b - a > least) left.push_back({a, b});
  };
  for (const Range& r : ranges_) {
    if (from >= r.to || to <= r.from) {
      left.push_back(r);
      continue;
    }
    if (from > r.from) keep(r.from, from);
    if (to < r.to) keep(to, r.to);
  }
  ranges_ = std::move(left);
}

}  // namespace gabarit
