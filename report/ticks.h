// Round numbers for axes and scales: 1, 2 or 5 times a power of ten.
#pragma once

#include <string>
#include <vector>

namespace gabarit {

// The smallest such number that is not under `value`, the largest that is not over it. `value` > 0, under
// 1e300.
double round_up(double value);
double round_down(double value);

struct Ticks {
  double step = 1;
  int decimals = 0;            // that tell neighbours apart
  std::vector<double> values;  // multiples of `step` in [low, high], ascending

  std::string text(double value) const;  // a label, such as "0.5"
};

// At most `most` (>= 2) of them. Empty unless low < high with a finite distance.
Ticks ticks(double low, double high, int most);

}  // namespace gabarit
