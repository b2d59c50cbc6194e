#include "report/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace gabarit {

// From the worst value to the limit, and from the limit to the best.
static constexpr std::array beyond{Rgb{110, 8, 26}, Rgb{178, 24, 36}, Rgb{222, 62, 40}, Rgb{244, 109, 60}};
static constexpr std::array within{Rgb{254, 246, 205}, Rgb{192, 222, 224}, Rgb{116, 173, 209}};
static constexpr std::array viridis{Rgb{68, 1, 84},    Rgb{70, 50, 127},  Rgb{54, 92, 141},
                                    Rgb{39, 127, 142}, Rgb{31, 161, 135}, Rgb{74, 194, 109},
                                    Rgb{159, 218, 58}, Rgb{253, 231, 37}};
static constexpr std::array rainbow{Rgb{214, 0, 0}, Rgb{250, 220, 0}, Rgb{40, 180, 60}, Rgb{0, 190, 220},
                                    Rgb{20, 40, 190}};

static std::uint8_t between(std::uint8_t a, std::uint8_t b, double t) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * t));
}

// `t` from 0, the first stop, to 1, the last one; outside: the ends.
static Rgb along(std::span<const Rgb> stops, double t) {
  const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double rest = at - static_cast<double>(i);
  const Rgb a = stops[i];
  const Rgb b = stops[i + 1];
  return {between(a.r, b.r, rest), between(a.g, b.g, rest), between(a.b, b.b, rest)};
}

// How far `value` is on the way from `from` to `to`; 0 when there is no way.
static double share(double value, double from, double to) {
  const double way = to - from;
  if (way == 0) return 0;
  const double t = (value - from) / way;
  return std::isnan(t) ? 1 : t;
}

static Rgb colour_by_limit(double value, const ColourScale& scale) {
  const Limit& limit = *scale.limit;
  const bool too_small = limit.kind != Limit::Kind::at_most && value < limit.low;
  const bool too_large = limit.kind != Limit::Kind::at_least && value > limit.high;
  if (too_small) return along(beyond, share(value, scale.low, limit.low));
  if (too_large) return along(beyond, share(value, scale.high, limit.high));
  if (limit.kind == Limit::Kind::at_least) return along(within, share(value, limit.low, scale.high));
  if (limit.kind == Limit::Kind::at_most) return along(within, share(value, limit.high, scale.low));
  const double middle = limit.low / 2 + limit.high / 2;
  return along(within, share(value, value < middle ? limit.low : limit.high, middle));
}

Rgb ColourScale::colour(double value) const {
  if (std::isnan(value)) return palette::no_value;
  if (map == ColourMap::by_limit && limit) return colour_by_limit(value, *this);
  const double t = share(value, low, high);
  return map == ColourMap::red_to_blue ? along(rainbow, t) : along(viridis, t);
}

}  // namespace gabarit
