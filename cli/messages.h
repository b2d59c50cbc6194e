// What the program says on standard error, and how it ends when the user can fix something.
#pragma once

#include <string>

#include "model/result.h"

namespace gabarit {

// Bad usage that the option parser does not know about; caught in main, which points to --help.
struct UsageError {
  std::string message;
};

// Control characters other than line ends and tabs are replaced: no file's content steers the terminal.
void print(const Diagnostics& diagnostics);
void print_error(const std::string& message);

// Standard output; throws UsageError when it can't be written. A reader that went away is no error.
void print_result(const std::string& text);

}  // namespace gabarit
