// What is left of an interval after open intervals are taken out of it.
#pragma once

#include <vector>

namespace gabarit {

class FreeIntervals {
 public:
  struct Range {
    double from, to;
  };

  FreeIntervals(double from, double to) : ranges_{{from, to}} {}

  // The ends stay free. What gets shorter than `least` is dropped.
  void take_out(double from, double to);
  bool empty() const { return ranges_.empty(); }
  const std::vector<Range>& ranges() const { return ranges_; }

  int changes() const { return changes_; }  // how often something was taken out

  double least = 0;

 private:
  int changes_ = 0;
  std::vector<Range> ranges_;  // ascending, disjoint
};

}  // namespace gabarit
