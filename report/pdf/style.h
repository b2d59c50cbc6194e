// The look of a report: one accent, two greys, sizes on a grid of 4.5 mm.
#pragma once

#include "report/pdf/document.h"
#include "report/pdf/fonts.h"
#include "report/picture.h"

namespace gabarit::pdf {

constexpr Rgb ink{28, 36, 45}, soft{96, 108, 122}, hairline{206, 213, 220}, shade{243, 245, 247},
    accent{11, 79, 108}, white{255, 255, 255};

struct TextStyle {
  Face face = Face::regular;
  double size = 9;  // points
  Rgb colour = ink;
  double leading = 4.5;  // mm from one baseline to the next
};

constexpr TextStyle body_text{};
constexpr TextStyle strong_text{Face::bold};
constexpr TextStyle quiet_text{Face::regular, 8, soft, 4.5};
constexpr TextStyle small_text{Face::regular, 7.5, ink, 3.75};
constexpr TextStyle small_strong_text{Face::bold, 7.5, ink, 3.75};
constexpr TextStyle label_text{Face::regular, 7.5, soft, 3.75};
constexpr TextStyle code_text{Face::mono, 6.5, ink, 3.3};
constexpr TextStyle title_text{Face::bold, 24, ink, 10.5};
constexpr TextStyle heading_text{Face::bold, 16, ink, 9};
constexpr TextStyle subheading_text{Face::bold, 10.5, accent, 4.5};

constexpr double grid_step = 4.5;                         // mm
constexpr double margin_left = 20, margin_right = 20;     // mm
constexpr double content_top = 29, content_bottom = 272;  // mm from the top of the page
constexpr double content_width = page_width - margin_left - margin_right;

}  // namespace gabarit::pdf
