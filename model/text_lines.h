// Text cut into lines and words; the line's number is for messages.
#pragma once

#include <cstdint>
#include <string_view>

namespace gabarit {

// Lines without their ends; CR, LF and CRLF each end one.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  // False at the end of the text.
  bool next(std::string_view& line);
  // Of the last line given, from 1; the largest int when there are more lines than that.
  int number() const;
  // What follows the last line given.
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::uint64_t number_ = 0;
};

// Takes the first word off `line`; empty when there is none. Blanks and tabs separate words.
std::string_view next_word(std::string_view& line);
std::string_view trimmed(std::string_view line);
// The line up to a comment: a `#` at its start or behind a blank.
std::string_view without_comment(std::string_view line);

}  // namespace gabarit
