// What the program tells a build server by ending.
#pragma once

#include "rules/outcome.h"

namespace gabarit {

enum ExitCode : int {
  exit_clean = 0,        // every rule passed or was not applicable
  exit_violation = 1,    // at least one proven violation
  exit_bad_input = 2,    // bad usage, rule file, model or output folder
  exit_not_decided = 3,  // no violation, but something is undecided or was not run
  exit_internal_error = 70,
};

// `undecided` makes an undecided rule count as a violation; `never` forgives violations and undecided rules.
// A rule that was not run is never forgiven: nothing is known about it.
enum class FailOn { fail, undecided, never };

ExitCode exit_code(const Outcome& outcome, FailOn fail_on);

}  // namespace gabarit
