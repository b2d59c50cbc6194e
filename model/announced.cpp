#include "model/announced.h"

#include <algorithm>
#include <charconv>
#include <map>

#include <fmt/format.h>

#include "model/text_encoding.h"

namespace gabarit {
namespace {

Diagnostics refuse(const std::string& name, int line, std::string message) {
  return {{.file = name, .line = line, .column = line > 0 ? 1 : 0, .message = std::move(message)}};
}

// Lines without their ends; CR, LF and CRLF all count.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line = rest_.substr(0, end);
    const bool crlf = end + 1 < rest_.size() && rest_[end] == '\r' && rest_[end + 1] == '\n';
    rest_.remove_prefix(std::min(rest_.size(), end + (crlf ? 2 : 1)));
    ++number_;
    return true;
  }
  int number() const { return number_; }

 private:
  std::string_view rest_;
  int number_ = 0;
};

std::string_view word(std::string_view& line) {
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  line.remove_prefix(begin);
  const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
  const std::string_view found = line.substr(0, end);
  line.remove_prefix(end);
  return found;
}

std::string_view trimmed(std::string_view line) {
  while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
  while (!line.empty() && (line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
  return line;
}

bool count(std::string_view text, std::uint64_t& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

// The shortest that so many vertices and faces can be written: two bytes a number.
Result<Announced> plausible(Announced found, std::uint64_t bytes, const std::string& name) {
  const std::uint64_t limit = bytes / 2 + 1;
  if (found.vertices > limit || found.faces > limit) {
    return refuse(name, 0,
                  fmt::format("the header announces {} vertices and {} faces, more than {} bytes can hold: "
                              "the file is cut short or damaged",
                              found.vertices, found.faces, bytes));
  }
  return found;
}

}  // namespace

Result<Announced> announced_ply(std::string_view bytes, const std::string& name) {
  Announced found;
  Lines lines(bytes.substr(0, 1U << 20U));
  std::string_view line;
  if (!lines.next(line) || trimmed(line) != "ply")
    return refuse(name, 1, "is not a PLY file: the first line should be 'ply'");
  std::uint64_t row_bytes = 0;
  bool binary = false;
  bool in_vertices = false;
  while (lines.next(line)) {
    const std::string_view key = word(line);
    if (key == "end_header") {
      if (binary && row_bytes > 0 && found.vertices > bytes.size() / row_bytes)
        found.vertices = bytes.size() + 2;
      return plausible(found, bytes.size(), name);
    }
    if (key == "format") binary = word(line) != "ascii";
    if (key == "property" && in_vertices) row_bytes += 1;
    if (key != "element") continue;
    const std::string_view element = word(line);
    std::uint64_t number = 0;
    if (!count(word(line), number))
      return refuse(name, lines.number(), "the number of elements is not a number");
    in_vertices = element == "vertex";
    if (element == "vertex") found.vertices = number;
    if (element == "face") found.faces = number;
  }
  return refuse(name, lines.number(), "the PLY header has no 'end_header'");
}

Result<Announced> announced_off(std::string_view bytes, const std::string& name) {
  Lines lines(bytes);
  std::string_view line;
  bool keyword_seen = false;
  while (lines.next(line)) {
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty()) continue;
    if (!keyword_seen) {
      const std::string_view keyword = word(line);
      if (keyword.find("OFF") == std::string_view::npos)
        return refuse(name, lines.number(), "is not an OFF file: the first word should be 'OFF'");
      keyword_seen = true;
      if (trimmed(line).empty()) continue;
    }
    Announced found;
    if (!count(word(line), found.vertices) || !count(word(line), found.faces)) {
      return refuse(name, lines.number(), "the numbers of vertices and faces should stand here");
    }
    return plausible(found, bytes.size(), name);
  }
  return refuse(name, lines.number(), "the file ends before the numbers of vertices and faces");
}

Announced announced_obj(std::string_view bytes) {
  Announced found;
  std::map<std::string, std::uint32_t, std::less<>> numbers;
  std::string body;
  Lines lines(bytes);
  std::string_view line;
  while (lines.next(line)) {
    const std::string_view key = word(line);
    if (key == "v") ++found.vertices;
    if (key == "o" || key == "g") body = valid_utf8(trimmed(line));
    if (key != "f") continue;
    ++found.faces;
    const auto [place, fresh] =
        numbers.try_emplace(body.empty() ? "default" : body, static_cast<std::uint32_t>(found.bodies.size()));
    if (fresh) found.bodies.push_back(place->first);
    found.face_body.push_back(place->second);
  }
  return found;
}

}  // namespace gabarit
