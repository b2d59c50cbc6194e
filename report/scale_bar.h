// The bar beside a picture that says how long a round length is in it.
#pragma once

#include <string>

#include "report/camera.h"

namespace gabarit {

struct ScaleBar {
  double length = 0;  // mm: 1, 2 or 5 times a power of ten
  double share = 0;   // of the picture's width
  int divisions = 1;  // alternating black and white parts, each a round length too
  std::string label;  // such as "200 mm" or "1 m"
};

// The longest that takes at most `share` of the picture's width. The picture is to scale in depth too: the
// view is orthographic.
ScaleBar scale_bar(const Camera& camera, double share = 0.25);

}  // namespace gabarit
