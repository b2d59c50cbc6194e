// Content from top to bottom over as many pages as it takes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/pdf/canvas.h"
#include "report/pdf/text_layout.h"

namespace gabarit::pdf {

class Flow {
 public:
  Flow(Document& document, Fonts& fonts) : document_(&document), fonts_(&fonts) {}

  Document& document() const { return *document_; }
  Fonts& fonts() const { return *fonts_; }
  // Only between the first begin_page() and the end.
  Canvas& canvas() { return *canvas_; }
  double y() const { return y_; }  // of the next content's top, mm
  double room() const { return content_bottom - y_; }

  // A new page under a running head; `section` names what follows there.
  void begin_page(const std::string& section);
  // A page without a running head, its content anywhere.
  Canvas& begin_bare_page();
  // Begins a page of the same section when less than `height` is left.
  void need(double height);
  void skip(double height) { y_ += height; }
  void move_to(double y) { y_ = y; }

  void heading(std::string_view text);     // up to two lines
  void subheading(std::string_view text);  // one line, kept with what follows
  void paragraph(std::string_view text, const TextStyle& style = body_text);
  // Of several, separated by empty lines.
  void paragraphs(std::string_view text, const TextStyle& style = body_text);
  // A name on the left and its value beside it, up to `most` lines of it.
  void entry(std::string_view name, std::string_view value, const TextStyle& style = body_text,
             std::size_t most = 6);

 private:
  Document* document_;
  Fonts* fonts_;
  std::optional<Canvas> canvas_;
  std::string section_;
  double y_ = content_top;
};

// Every page's foot: "report <id>" and "n of m".
void number_pages(Document& document, Fonts& fonts, const std::string& text);

// A sentence of `quiet` text at most.
constexpr double entry_indent = 42;  // mm

}  // namespace gabarit::pdf
