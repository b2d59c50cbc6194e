// One page to draw on; millimetres from its top left corner.
#pragma once

#include <span>
#include <string_view>

#include "report/pdf/style.h"

namespace gabarit::pdf {

struct Place {
  double x = 0, y = 0;
};

struct Area {
  double x = 0, y = 0, width = 0, height = 0;
};

class Canvas {
 public:
  Canvas(Document& document, Fonts& fonts, HPDF_Page page)
      : document_(&document), fonts_(&fonts), page_(page) {}
  Document& document() const { return *document_; }
  Fonts& fonts() const { return *fonts_; }

  // On one line, its baseline at y; as wide as it gets (see fitted()).
  void text(Place at, std::string_view text, const TextStyle& style);
  void text_right(Place at, std::string_view text, const TextStyle& style);
  void text_centred(Place at, std::string_view text, const TextStyle& style);
  double width(std::string_view text, const TextStyle& style) const;  // mm

  void line(Place from, Place to, Rgb colour, double width = 0.2);
  void dashed_line(Place from, Place to, Rgb colour, double width = 0.2);
  void polyline(std::span<const Place> places, Rgb colour, double width = 0.2);
  void polygon(std::span<const Place> places, Rgb fill);
  void circle(Place centre, double radius, Rgb colour, double width = 0.2);
  void disk(Place centre, double radius, Rgb fill);
  void fill(const Area& area, Rgb colour);
  void frame(const Area& area, Rgb colour, double width = 0.2);
  void picture(const Area& area, HPDF_Image picture);
  // What `draw` draws stays within the area.
  template <class Draw>
  void clipped(const Area& area, const Draw& draw) {
    begin_clip(area);
    draw();
    end_clip();
  }

 private:
  HPDF_REAL x(double mm) const;
  HPDF_REAL y(double mm) const;
  void stroke_style(Rgb colour, double width);
  void fill_style(Rgb colour);
  void trace(std::span<const Place> places);
  void begin_clip(const Area& area);
  void end_clip();

  Document* document_;
  Fonts* fonts_;
  HPDF_Page page_;
};

}  // namespace gabarit::pdf
