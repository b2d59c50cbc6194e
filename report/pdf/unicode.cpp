#include "report/pdf/unicode.h"

namespace gabarit::pdf {

namespace {

constexpr char32_t replacement = 0xFFFD;

struct Decoded {
  char32_t code;
  std::size_t bytes;
};

// The first code point of a text that is not empty; a byte that begins none is one replacement.
Decoded decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t length = first >= 0xF0 && first < 0xF5 ? 4 : first >= 0xE0 ? 3 : first >= 0xC2 ? 2 : 0;
  if (length == 0 || first >= 0xF5 || text.size() < length) return {replacement, 1};
  char32_t code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {replacement, 1};
    code = code << 6 | (byte(i) & 0x3FU);
  }
  const char32_t least = length == 2 ? 0x80 : length == 3 ? 0x800 : 0x10000;
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  if (code < least || code > 0x10FFFF || surrogate) return {replacement, 1};
  return {code, length};
}

bool within(char32_t code, char32_t first, char32_t last) { return code >= first && code <= last; }

bool is_control(char32_t code) {
  return code < 0x20 || within(code, 0x7F, 0x9F) || within(code, 0x200E, 0x200F) ||
         within(code, 0x2028, 0x202E) || within(code, 0x2066, 0x206F) || within(code, 0xFFF0, 0xFFFB);
}

}  // namespace

std::u32string code_points(std::string_view text) {
  std::u32string codes;
  codes.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const Decoded d = decode(text.substr(i));
    i += d.bytes;
    const bool space = d.code == '\t' || d.code == '\n' || d.code == '\r' || d.code == 0xA0;
    codes.push_back(space ? U' ' : is_control(d.code) ? replacement : d.code);
  }
  return codes;
}

void append_utf8(std::string& text, char32_t code) {
  const auto put = [&](char32_t byte) { text.push_back(static_cast<char>(byte)); };
  if (code < 0x80) return put(code);
  if (code < 0x800) return put(0xC0 | code >> 6), put(0x80 | (code & 0x3F));
  if (code < 0x10000)
    return put(0xE0 | code >> 12), put(0x80 | (code >> 6 & 0x3F)), put(0x80 | (code & 0x3F));
  put(0xF0 | code >> 18), put(0x80 | (code >> 12 & 0x3F)), put(0x80 | (code >> 6 & 0x3F));
  put(0x80 | (code & 0x3F));
}

std::string utf8(std::u32string_view codes) {
  std::string text;
  for (const char32_t code : codes) append_utf8(text, code);
  return text;
}

bool is_invisible(char32_t code) {
  return within(code, 0x200B, 0x200D) || code == 0x2060 || code == 0xFEFF || within(code, 0xFE00, 0xFE0F) ||
         code == 0xAD;
}

bool is_right_to_left(char32_t code) {
  return within(code, 0x590, 0x8FF) || within(code, 0xFB1D, 0xFDFF) || within(code, 0xFE70, 0xFEFC);
}

bool is_ideograph(char32_t code) {
  return within(code, 0x2E80, 0x9FFF) || within(code, 0xAC00, 0xD7A3) || within(code, 0xF900, 0xFAFF) ||
         within(code, 0xFF01, 0xFFEF);
}

}  // namespace gabarit::pdf
