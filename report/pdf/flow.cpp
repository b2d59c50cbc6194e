#include "report/pdf/flow.h"

#include <algorithm>

#include <fmt/format.h>

namespace gabarit::pdf {

constexpr double right_edge = page_width - margin_right;
// Where the baseline lies below the top of a line of text.
static double ascent(const TextStyle& style) { return 0.75 * style.leading; }

Canvas& Flow::begin_bare_page() {
  canvas_.emplace(*document_, *fonts_, document_->add_page());
  y_ = content_top;
  reserved_ = {};
  return *canvas_;
}

void Flow::begin_page(const std::string& section) {
  section_ = section;
  begin_bare_page();
  canvas_->text({margin_left, 18}, "GABARIT", {Face::bold, 7.5, accent});
  const double width = content_width - 30;
  canvas_->text_right({right_edge, 18}, fitted(*fonts_, section, label_text, width), label_text);
  canvas_->line({margin_left, 20.5}, {right_edge, 20.5}, hairline);
}

Area Flow::reserve_right(double width, double height) {
  need(height);
  return reserved_ = {right_edge - width, y_, width, height};
}

void Flow::pass_reserved() {
  y_ = std::max(y_, reserved_.y + reserved_.height);
  reserved_ = {};
}

double Flow::text_width() const {
  constexpr double gap = 6;
  return y_ < reserved_.y + reserved_.height ? content_width - reserved_.width - gap : content_width;
}

void Flow::need(double height) {
  if (room() < height) begin_page(section_);
}

void Flow::heading(std::string_view text) {
  for (const std::string& line : wrap(*fonts_, text, heading_text, content_width, 2)) {
    canvas_->text({margin_left, y_ + 6}, line, heading_text);
    y_ += heading_text.leading;
  }
  y_ += grid_step / 2;
}

void Flow::subheading(std::string_view text, double kept) {
  need(2 * grid_step + kept);
  if (y_ > content_top) y_ += 0.8 * grid_step;
  canvas_->text({margin_left, y_ + ascent(subheading_text)},
                fitted(*fonts_, text, subheading_text, content_width), subheading_text);
  y_ += 1.5 * grid_step;
}

void Flow::paragraph(std::string_view text, const TextStyle& style, std::size_t most) {
  for (const std::string& line : wrap(*fonts_, text, style, text_width(), most)) {
    need(style.leading);
    canvas_->text({margin_left, y_ + ascent(style)}, line, style);
    y_ += style.leading;
  }
  y_ += grid_step / 2;
}

void Flow::paragraphs(std::string_view text, const TextStyle& style) {
  while (!text.empty()) {
    const std::size_t end = text.find("\n\n");
    paragraph(text.substr(0, end), style);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 2);
  }
}

void Flow::entry(std::string_view name, std::string_view value, const TextStyle& style, std::size_t most) {
  const std::vector<std::string> lines = wrap(*fonts_, value, style, text_width() - entry_indent, most);
  need(static_cast<double>(lines.size()) * style.leading);
  canvas_->text({margin_left, y_ + ascent(style)}, fitted(*fonts_, name, label_text, entry_indent - 3),
                label_text);
  for (const std::string& line : lines) {
    canvas_->text({margin_left + entry_indent, y_ + ascent(style)}, line, style);
    y_ += style.leading;
  }
  y_ += 0.9;
}

void number_pages(Document& document, Fonts& fonts, const std::string& text) {
  const std::size_t count = document.pages().size();
  for (std::size_t i = 0; i < count; ++i) {
    Canvas canvas(document, fonts, document.pages()[i]);
    canvas.line({margin_left, 280}, {right_edge, 280}, hairline);
    canvas.text({margin_left, 284.5}, fitted(fonts, text, label_text, content_width - 25), label_text);
    canvas.text_right({right_edge, 284.5}, fmt::format("{} of {}", i + 1, count), label_text);
  }
}

}  // namespace gabarit::pdf
