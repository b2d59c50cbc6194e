// The result of a run as text for a terminal.
#pragma once

#include <string>

#include "report/report.h"

namespace gabarit {

struct TerminalStyle {
  bool colour = false;
  std::size_t findings = 10;  // listed for each rule
};

// What needs attention comes first: failed, not run, undecided, passed, not applicable; the totals come last.
// Control characters in names are replaced, so that no model or rule file can steer the terminal.
std::string terminal_report(const Report& report, const TerminalStyle& style = {});

}  // namespace gabarit
