#include "cli/messages.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace gabarit {

static std::string printable(std::string text) {
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7F) c = '?';
  }
  return text;
}

void print(const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics)
    std::fputs(printable(to_string(diagnostic)).c_str(), stderr);
}

void print_error(const std::string& message) {
  std::fputs(printable("gabarit: error: " + message + '\n').c_str(), stderr);
}

void print_result(const std::string& text) {
  errno = 0;
  const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if ((std::fflush(stdout) == 0 && whole) || errno == EPIPE) return;
  throw UsageError{std::string("cannot write to standard output: ") + std::strerror(errno)};
}

}  // namespace gabarit
