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
  // Keeps the right of the page free for a figure; paragraphs and entries that begin beside it are narrower.
  Area reserve_right(double width, double height);
  void pass_reserved();  // goes on below it
  void skip(double height) { y_ += height; }
  void move_to(double y) { y_ = y; }

  void heading(std::string_view text);  // up to two lines
  // One line, on one page with the `kept` mm that follow.
  void subheading(std::string_view text, double kept = 3 * grid_step);
  void paragraph(std::string_view text, const TextStyle& style = body_text, std::size_t most = any_number);
  // Of several, separated by empty lines.
  void paragraphs(std::string_view text, const TextStyle& style = body_text);
  // A name on the left and its value beside it, up to `most` lines of it.
  void entry(std::string_view name, std::string_view value, const TextStyle& style = body_text,
             std::size_t most = 6);

 private:
  Document* document_;
  Fonts* fonts_;
  double text_width() const;

  std::optional<Canvas> canvas_;
  Area reserved_;
  std::string section_;
  double y_ = content_top;
};

// Every page's foot: "report <id>" and "n of m".
void number_pages(Document& document, Fonts& fonts, const std::string& text);

// Where the values of entries begin, from the left of the content.
constexpr double entry_indent = 42;  // mm

}  // namespace gabarit::pdf
