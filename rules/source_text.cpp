#include "rules/source_text.h"

#include <algorithm>

#include <fmt/format.h>

namespace gabarit {

namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 20;

struct Range {
  unsigned char from, to;
};

// How many bytes the UTF-8 character at `at` has; 0 when it is none (Unicode 15, table 3-7).
std::size_t utf8_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(i < text.size() ? text[i] : 0); };
  const unsigned char first = byte(at);
  if (first < 0x80) return 1;
  const std::size_t n = first >= 0xC2 && first <= 0xDF ? 2 : (first & 0xF0U) == 0xE0 ? 3 : 4;
  if (n == 4 && (first < 0xF0 || first > 0xF4)) return 0;
  Range second{0x80, 0xBF};
  if (first == 0xE0) second.from = 0xA0;
  if (first == 0xED) second.to = 0x9F;
  if (first == 0xF0) second.from = 0x90;
  if (first == 0xF4) second.to = 0x8F;
  if (byte(at + 1) < second.from || byte(at + 1) > second.to) return 0;
  for (std::size_t i = 2; i < n; ++i) {
    if ((byte(at + i) & 0xC0U) != 0x80) return 0;
  }
  return n;
}

// What is wrong with the character at `at`, apart from its bytes.
std::string fault_of_character(const std::string& text, std::size_t at, bool indentation) {
  const auto c = static_cast<unsigned char>(text[at]);
  if (c == '\t') return indentation ? "a tab in the indentation" : "";
  if (c == '\r') return at + 1 < text.size() && text[at + 1] == '\n' ? "" : "a carriage return within a line";
  if ((c < 0x20 && c != '\n') || c == 0x7F) return fmt::format("a control character (0x{:02X})", c);
  return "";
}

}  // namespace

std::optional<TextFault> find_text_fault(const std::string& text) {
  if (text.size() > most_bytes) {
    return TextFault{
        .line = 0, .message = "the file is larger than 1 MiB", .hint = "rule files are small: is this one?"};
  }
  int line = 1;
  std::size_t begin = 0;
  bool indentation = true;
  for (std::size_t i = 0; i < text.size();) {
    const int column = static_cast<int>(i - begin) + 1;
    const std::size_t n = utf8_length(text, i);
    if (n == 0) {
      return TextFault{line, column,
                       fmt::format("the byte 0x{:02X} is not UTF-8", static_cast<unsigned char>(text[i])),
                       "save the file as UTF-8"};
    }
    std::string fault = fault_of_character(text, i, indentation);
    if (!fault.empty()) {
      const bool tab = text[i] == '\t';
      return TextFault{line, column, std::move(fault),
                       tab ? "YAML is indented with spaces" : "save the file as plain UTF-8 text"};
    }
    indentation = text[i] == '\n' || (indentation && text[i] == ' ');
    i += n;
    if (text[i - 1] == '\n') ++line, begin = i;
  }
  return std::nullopt;
}

std::string line_of(const std::string& text, int line) {
  std::size_t begin = 0;
  for (int i = 1; i < line; ++i) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) return {};
    begin = end + 1;
  }
  std::string result = text.substr(begin, std::min(text.find('\n', begin), text.size()) - begin);
  if (result.ends_with('\r')) result.pop_back();
  return result;
}

int character_count(const std::string& text) {
  return static_cast<int>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace gabarit
