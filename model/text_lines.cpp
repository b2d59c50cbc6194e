#include "model/text_lines.h"

#include <algorithm>
#include <limits>

namespace gabarit {

static bool blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

bool Lines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const auto is_end = [](char c) { return c == '\n' || c == '\r'; };
  const auto end = static_cast<std::size_t>(std::find_if(rest_.begin(), rest_.end(), is_end) - rest_.begin());
  line = rest_.substr(0, end);
  const bool crlf = end + 1 < rest_.size() && rest_[end] == '\r' && rest_[end + 1] == '\n';
  rest_.remove_prefix(std::min(rest_.size(), end + (crlf ? 2 : 1)));
  ++number_;
  return true;
}

int Lines::number() const {
  return static_cast<int>(std::min<std::uint64_t>(number_, std::numeric_limits<int>::max()));
}

std::string_view next_word(std::string_view& line) {
  const auto begin = std::find_if_not(line.begin(), line.end(), blank);
  const auto end = std::find_if(begin, line.end(), blank);
  const auto at = static_cast<std::size_t>(begin - line.begin());
  const std::string_view word = line.substr(at, static_cast<std::size_t>(end - begin));
  line.remove_prefix(at + word.size());
  return word;
}

std::string_view trimmed(std::string_view line) {
  while (!line.empty() && blank(line.front())) line.remove_prefix(1);
  while (!line.empty() && blank(line.back())) line.remove_suffix(1);
  return line;
}

std::string_view without_comment(std::string_view line) {
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1)) {
    if (at == 0 || blank(line[at - 1])) return line.substr(0, at);
  }
  return line;
}

}  // namespace gabarit
