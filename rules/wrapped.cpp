#include "rules/wrapped.h"

#include <sstream>

#include "rules/source_text.h"

namespace gabarit {

namespace {

class Lines {
 public:
  Lines(int width, int indent) : width_(width), indent_(static_cast<std::size_t>(indent), ' ') {}

  void word(const std::string& word) {
    const int length = character_count(word);
    if (used_ > 0 && used_ + 1 + length > width_) end_line();
    if (used_ == 0) {
      text_ += indent_;
      used_ = static_cast<int>(indent_.size());
    } else {
      text_ += ' ';
      ++used_;
    }
    text_ += word;
    used_ += length;
  }
  void end_line() {
    if (used_ > 0) text_ += '\n';
    used_ = 0;
  }
  void empty_line() {
    end_line();
    text_ += '\n';
  }
  std::string text() {
    end_line();
    return std::move(text_);
  }

 private:
  int width_;
  std::string indent_;
  std::string text_;
  int used_ = 0;
};

}  // namespace

std::string wrapped(const std::string& text, int width, int indent) {
  Lines lines(width, indent);
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty()) lines.empty_line();
    if (line.starts_with("- ")) lines.end_line();
    std::istringstream words(line);
    for (std::string word; words >> word;) lines.word(word);
  }
  return lines.text();
}

}  // namespace gabarit
