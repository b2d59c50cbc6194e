#include "report/ticks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace gabarit {

// Correctly rounded for the exponents that lengths have: 0.2 is 2 / 10, not 2 * 0.1.
static double scaled(double mantissa, int exponent) {
  return exponent < 0 ? mantissa / std::pow(10.0, -exponent) : mantissa * std::pow(10.0, exponent);
}

// Under it, and powers of ten could not be told from zero.
static constexpr double smallest_step = 1e-300;

static int decade(double value) { return static_cast<int>(std::floor(std::log10(value))); }

double round_up(double value) {
  if (value < smallest_step) return smallest_step;
  const int exponent = decade(value) - 1;  // one early, since the logarithm is rounded
  for (const double mantissa : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    if (scaled(mantissa, exponent) >= value) return scaled(mantissa, exponent);
  }
  return scaled(100, exponent);
}

double round_down(double value) {
  if (value < smallest_step) return value;
  const int exponent = decade(value) - 1;
  for (const double mantissa : {100.0, 50.0, 20.0, 10.0, 5.0, 2.0}) {
    if (scaled(mantissa, exponent) <= value) return scaled(mantissa, exponent);
  }
  return scaled(1, exponent);
}

std::string Ticks::text(double value) const {
  return fmt::format("{:.{}f}", value == 0 ? 0 : value, decimals);
}

Ticks ticks(double low, double high, int most) {
  Ticks result;
  const double raw = (high - low) / std::max(most, 2);
  if (!(raw > smallest_step) || !std::isfinite(raw)) return result;
  result.step = round_up(raw);
  double first = std::ceil(low / result.step);
  if (std::floor(high / result.step) - first >= std::max(most, 2)) {
    result.step = round_up(result.step * 1.5);
    first = std::ceil(low / result.step);
  }
  result.decimals = std::max(0, -decade(result.step * 1.01));
  const double count = std::floor(high / result.step) - first + 1;
  for (int i = 0; i < count; ++i) result.values.push_back((first + i) * result.step);
  return result;
}

}  // namespace gabarit
