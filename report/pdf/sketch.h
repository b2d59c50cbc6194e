// Small drawings of what a selector or a measure means, for the method pages.
#pragma once

#include "checks/check.h"
#include "report/pdf/canvas.h"

namespace gabarit::pdf {

constexpr double sketch_width = 52, sketch_height = 36;  // mm

// Drawings are known by name; a check without one is explained by its text alone.
bool has_sketch(const Selector& selector);
bool has_sketch(const Measure& measure);
void draw_sketch(Canvas& canvas, const Area& area, const Selector& selector, const Arguments& arguments);
void draw_sketch(Canvas& canvas, const Area& area, const Measure& measure);

}  // namespace gabarit::pdf
