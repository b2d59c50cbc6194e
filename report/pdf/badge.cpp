#include "report/pdf/badge.h"

#include <array>

namespace gabarit::pdf {

const char* verdict_word(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass: return "PASS";
    case Verdict::fail: return "FAIL";
    case Verdict::undecided: return "UNDECIDED";
    case Verdict::not_applicable: return "NOT APPLICABLE";
    case Verdict::not_run: break;
  }
  return "NOT RUN";
}

Rgb verdict_colour(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass: return {22, 110, 83};
    case Verdict::fail: return {176, 32, 36};
    case Verdict::undecided: return {156, 91, 0};
    case Verdict::not_applicable: return {96, 108, 122};
    case Verdict::not_run: break;
  }
  return {84, 60, 124};
}

void draw_sign(Canvas& canvas, Place c, double size, Verdict verdict, Rgb colour) {
  const double h = size / 2, thick = size * 0.17;
  switch (verdict) {
    case Verdict::pass: {
      const std::array tick{Place{c.x - h, c.y}, Place{c.x - 0.3 * h, c.y + 0.8 * h},
                            Place{c.x + h, c.y - 0.8 * h}};
      return canvas.polyline(tick, colour, thick);
    }
    case Verdict::fail:
      canvas.line({c.x - 0.8 * h, c.y - 0.8 * h}, {c.x + 0.8 * h, c.y + 0.8 * h}, colour, thick);
      return canvas.line({c.x - 0.8 * h, c.y + 0.8 * h}, {c.x + 0.8 * h, c.y - 0.8 * h}, colour, thick);
    case Verdict::undecided: {
      const TextStyle style{Face::bold, 1.35 * size * points_per_mm, colour};
      return canvas.text_centred({c.x, c.y + 0.49 * size}, "?", style);
    }
    case Verdict::not_applicable: return canvas.line({c.x - h, c.y}, {c.x + h, c.y}, colour, thick);
    case Verdict::not_run: break;
  }
  canvas.circle(c, 0.8 * h, colour, thick);
  canvas.line({c.x - 0.55 * h, c.y + 0.55 * h}, {c.x + 0.55 * h, c.y - 0.55 * h}, colour, thick);
}

void draw_small_badge(Canvas& canvas, Place at, Verdict verdict) {
  const Rgb colour = verdict_colour(verdict);
  draw_sign(canvas, {at.x + 1.4, at.y - 0.95}, 2.1, verdict, colour);
  canvas.text({at.x + 4, at.y}, verdict_word(verdict), {Face::bold, 7, colour});
}

void draw_plate(Canvas& canvas, const Area& area, Verdict verdict) {
  canvas.fill(area, verdict_colour(verdict));
  const double size = 0.4 * area.height;
  draw_sign(canvas, {area.x + 0.55 * area.height, area.y + area.height / 2}, size, verdict, white);
  const double points = 0.46 * area.height * points_per_mm;
  canvas.text({area.x + 1.05 * area.height, area.y + 0.67 * area.height}, verdict_word(verdict),
              {Face::bold, points, white});
}

}  // namespace gabarit::pdf
