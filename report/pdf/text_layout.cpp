#include "report/pdf/text_layout.h"

#include <algorithm>

#include "report/pdf/unicode.h"

namespace gabarit::pdf {

namespace {

class Breaker {
 public:
  Breaker(Fonts& fonts, const TextStyle& style, double width)
      : fonts_(fonts), face_(style.face), room_(width * points_per_mm / style.size) {}

  // How many code points from `from` on make the next line; at least one.
  std::size_t line(std::u32string_view codes, std::size_t from) const {
    double used = 0;
    std::size_t good = 0;  // length up to the last place where a line may end
    for (std::size_t i = from; i < codes.size(); ++i) {
      used += fonts_.width(face_, codes[i]);
      if (used > room_ && codes[i] != U' ') return good > 0 ? good : std::max<std::size_t>(1, i - from);
      if (codes[i] == U' ' || is_ideograph(codes[i])) good = i - from + 1;
    }
    return codes.size() - from;
  }

  // The beginning of the line that still leaves room for "…" after it.
  std::u32string cut(std::u32string_view codes) const {
    double used = fonts_.width(face_, U'…');
    std::size_t kept = 0;
    while (kept < codes.size() && (used += fonts_.width(face_, codes[kept])) <= room_) ++kept;
    while (kept > 0 && codes[kept - 1] == U' ') --kept;
    return std::u32string(codes.substr(0, kept)) + U'…';
  }

  double width(std::u32string_view codes) const {
    double sum = 0;
    for (const char32_t code : codes) sum += fonts_.width(face_, code);
    return sum;
  }
  double room() const { return room_; }

 private:
  Fonts& fonts_;
  Face face_;
  double room_;  // at a size of one
};

std::u32string_view without_end_spaces(std::u32string_view line) {
  while (!line.empty() && line.back() == U' ') line.remove_suffix(1);
  return line;
}

}  // namespace

std::vector<std::string> wrap(Fonts& fonts, std::string_view text, const TextStyle& style, double width,
                              std::size_t most) {
  const Breaker breaker(fonts, style, width);
  std::vector<std::string> lines;
  bool more = true;
  while (more && lines.size() < most) {
    const std::size_t end = text.find('\n');
    more = end != std::string_view::npos;
    std::string_view part = text.substr(0, end);
    if (!part.empty() && part.back() == '\r') part.remove_suffix(1);
    // A cut at a byte may show a broken letter, but only behind the last line that is kept.
    constexpr std::size_t most_bytes_a_line = 4000;
    if (most < 1000) part = part.substr(0, most * most_bytes_a_line);
    const std::u32string codes = code_points(part);
    std::size_t from = 0;
    do {
      const std::size_t count = breaker.line(codes, from);
      const std::u32string_view line = std::u32string_view(codes).substr(from, count);
      from += codes.empty() ? 0 : count;
      const bool cut = lines.size() + 1 == most && (from < codes.size() || more);
      lines.push_back(utf8(cut ? breaker.cut(line) : std::u32string(without_end_spaces(line))));
    } while (from < codes.size() && lines.size() < most);
    if (more) text.remove_prefix(end + 1);
  }
  return lines;
}

TextStyle shrunk(Fonts& fonts, std::string_view line, TextStyle style, double width) {
  const double taken = fonts.width(style.face, line) * style.size / points_per_mm;
  if (taken > width) style.size *= width / taken;
  return style;
}

std::string fitted(Fonts& fonts, std::string_view text, const TextStyle& style, double width) {
  const Breaker breaker(fonts, style, width);
  const std::u32string codes = code_points(text.substr(0, 4000));
  return utf8(breaker.width(codes) <= breaker.room() ? codes : breaker.cut(codes));
}

}  // namespace gabarit::pdf
