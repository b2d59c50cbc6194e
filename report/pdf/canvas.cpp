#include "report/pdf/canvas.h"

#include <array>

namespace gabarit::pdf {

static HPDF_REAL points(double mm) { return static_cast<HPDF_REAL>(mm * points_per_mm); }
static HPDF_REAL share(std::uint8_t channel) { return static_cast<HPDF_REAL>(channel) / 255; }

HPDF_REAL Canvas::x(double mm) const { return points(mm); }
HPDF_REAL Canvas::y(double mm) const { return points(page_height - mm); }

void Canvas::stroke_style(Rgb colour, double width) {
  HPDF_Page_SetRGBStroke(page_, share(colour.r), share(colour.g), share(colour.b));
  HPDF_Page_SetLineWidth(page_, points(width));
}

void Canvas::fill_style(Rgb colour) {
  HPDF_Page_SetRGBFill(page_, share(colour.r), share(colour.g), share(colour.b));
}

void Canvas::text(Place at, std::string_view text, const TextStyle& style) {
  fill_style(style.colour);
  for (const Run& run : fonts_->runs(style.face, text)) {
    HPDF_Page_BeginText(page_);
    HPDF_Page_SetFontAndSize(page_, run.font, static_cast<HPDF_REAL>(style.size));
    HPDF_Page_TextOut(page_, x(at.x), y(at.y), run.bytes.c_str());
    HPDF_Page_EndText(page_);
    at.x += run.width * style.size / points_per_mm;
  }
}

double Canvas::width(std::string_view text, const TextStyle& style) const {
  return fonts_->width(style.face, text) * style.size / points_per_mm;
}

void Canvas::text_right(Place at, std::string_view line, const TextStyle& style) {
  text({at.x - width(line, style), at.y}, line, style);
}

void Canvas::text_centred(Place at, std::string_view line, const TextStyle& style) {
  text({at.x - width(line, style) / 2, at.y}, line, style);
}

void Canvas::trace(std::span<const Place> places) {
  HPDF_Page_MoveTo(page_, x(places[0].x), y(places[0].y));
  for (const Place& p : places.subspan(1)) HPDF_Page_LineTo(page_, x(p.x), y(p.y));
}

void Canvas::polyline(std::span<const Place> places, Rgb colour, double width) {
  if (places.size() < 2) return;
  stroke_style(colour, width);
  trace(places);
  HPDF_Page_Stroke(page_);
}

void Canvas::line(Place from, Place to, Rgb colour, double width) {
  polyline(std::array{from, to}, colour, width);
}

void Canvas::dashed_line(Place from, Place to, Rgb colour, double width) {
  constexpr std::array<HPDF_UINT16, 1> dash{2};
  HPDF_Page_SetDash(page_, dash.data(), 1, 0);
  line(from, to, colour, width);
  HPDF_Page_SetDash(page_, nullptr, 0, 0);
}

void Canvas::polygon(std::span<const Place> places, Rgb colour) {
  if (places.size() < 3) return;
  fill_style(colour);
  trace(places);
  HPDF_Page_Fill(page_);
}

void Canvas::circle(Place centre, double radius, Rgb colour, double width) {
  stroke_style(colour, width);
  HPDF_Page_Circle(page_, x(centre.x), y(centre.y), points(radius));
  HPDF_Page_Stroke(page_);
}

void Canvas::disk(Place centre, double radius, Rgb colour) {
  fill_style(colour);
  HPDF_Page_Circle(page_, x(centre.x), y(centre.y), points(radius));
  HPDF_Page_Fill(page_);
}

void Canvas::fill(const Area& a, Rgb colour) {
  fill_style(colour);
  HPDF_Page_Rectangle(page_, x(a.x), y(a.y + a.height), points(a.width), points(a.height));
  HPDF_Page_Fill(page_);
}

void Canvas::frame(const Area& a, Rgb colour, double width) {
  stroke_style(colour, width);
  HPDF_Page_Rectangle(page_, x(a.x), y(a.y + a.height), points(a.width), points(a.height));
  HPDF_Page_Stroke(page_);
}

void Canvas::picture(const Area& a, HPDF_Image picture) {
  HPDF_Page_DrawImage(page_, picture, x(a.x), y(a.y + a.height), points(a.width), points(a.height));
}

void Canvas::begin_clip(const Area& a) {
  HPDF_Page_GSave(page_);
  HPDF_Page_Rectangle(page_, x(a.x), y(a.y + a.height), points(a.width), points(a.height));
  HPDF_Page_Clip(page_);
  HPDF_Page_EndPath(page_);
}

void Canvas::end_clip() { HPDF_Page_GRestore(page_); }

}  // namespace gabarit::pdf
