// What went wrong, where, and what to do about it.
#pragma once

#include <string>
#include <vector>

namespace gabarit {

struct Diagnostic {
  enum class Level { note, warning, error };
  Level level = Level::error;
  std::string file;
  int line = 0;    // from 1; 0: the whole file
  int column = 0;  // from 1
  std::string message;
  std::string source_line = {};  // the offending line of text, when there is one
  int length = 1;                // how many characters the caret underlines
  std::string hint = {};         // what would be right, such as the nearest known name
};

// "file:line:column: error: message", the line, a caret, and the hint, each on its own line.
std::string to_string(const Diagnostic& diagnostic);

}  // namespace gabarit
