// Checks of a text before anything parses it, and its lines for messages.
#pragma once

#include <optional>
#include <string>

namespace gabarit {

struct TextFault {
  int line = 1, column = 1;  // from 1, in bytes
  std::string message, hint;
};

// The first thing that no rule file may hold: more than 1 MiB, bytes that are not UTF-8, control characters,
// a tab in the indentation.
std::optional<TextFault> find_text_fault(const std::string& text);

// Without its end of line; empty past the end.
std::string line_of(const std::string& text, int line);

// Characters, not bytes.
int character_count(const std::string& text);

}  // namespace gabarit
