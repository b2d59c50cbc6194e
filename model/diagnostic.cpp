#include "model/diagnostic.h"

#include <fmt/format.h>

namespace gabarit {

static const char* name(Diagnostic::Level level) {
  switch (level) {
    case Diagnostic::Level::note: return "note";
    case Diagnostic::Level::warning: return "warning";
    case Diagnostic::Level::error: break;
  }
  return "error";
}

std::string to_string(const Diagnostic& d) {
  std::string text = d.file;
  if (d.line > 0) text += fmt::format(":{}:{}", d.line, d.column);
  text += fmt::format("{}{}: {}\n", text.empty() ? "" : ": ", name(d.level), d.message);
  if (!d.source_line.empty()) {
    text += fmt::format("  {}\n", d.source_line);
    // The caret stands under a tab-free copy of what comes before it.
    std::string indent(2, ' ');
    for (int i = 0; i + 1 < d.column && i < static_cast<int>(d.source_line.size()); ++i) {
      const auto c = static_cast<unsigned char>(d.source_line[static_cast<std::size_t>(i)]);
      if ((c & 0xC0U) != 0x80U) indent += c == '\t' ? '\t' : ' ';
    }
    text += indent + '^' + std::string(static_cast<std::size_t>(d.length > 1 ? d.length - 1 : 0), '~') + '\n';
  }
  if (!d.hint.empty()) text += fmt::format("  {}\n", d.hint);
  return text;
}

}  // namespace gabarit
