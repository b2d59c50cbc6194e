#include "report/scale_bar.h"

#include <cmath>

#include <fmt/format.h>

#include "report/ticks.h"

namespace gabarit {

// 1 and 5 part into fifths (0.2, 1), 2 into quarters (0.5).
static int divisions_of(double length) {
  const double next = round_up(length * 1.01);
  return next / length > 2.2 ? 4 : 5;
}

ScaleBar scale_bar(const Camera& camera, double share) {
  ScaleBar bar;
  const double most = camera.width * share;
  if (!(most > 0) || !std::isfinite(most)) return bar;
  bar.length = round_down(most);
  bar.share = bar.length / camera.width;
  bar.divisions = divisions_of(bar.length);
  bar.label =
      bar.length >= 1000 ? fmt::format("{:g} m", bar.length / 1000) : fmt::format("{:g} mm", bar.length);
  return bar;
}

}  // namespace gabarit
