#include "cli/exit_code.h"

namespace gabarit {

ExitCode exit_code(const Outcome& outcome, FailOn fail_on) {
  const Totals& totals = outcome.totals;
  const bool violation = fail_on != FailOn::never &&
                         (totals.failed > 0 || (fail_on == FailOn::undecided && totals.undecided > 0));
  if (violation) return exit_violation;
  if (totals.not_run > 0 || totals.planned == 0) return exit_not_decided;
  return fail_on == FailOn::fail && totals.undecided > 0 ? exit_not_decided : exit_clean;
}

}  // namespace gabarit
