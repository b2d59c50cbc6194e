#include "rules/totals.h"

namespace gabarit {

Totals count(std::span<const RuleResult> results) {
  Totals totals;
  totals.planned = results.size();
  for (const RuleResult& result : results) {
    switch (result.verdict) {
      case Verdict::pass: ++totals.passed; break;
      case Verdict::fail: ++totals.failed; break;
      case Verdict::undecided: ++totals.undecided; break;
      case Verdict::not_applicable: ++totals.not_applicable; break;
      case Verdict::not_run: ++totals.not_run; break;
    }
  }
  return totals;
}

Verdict overall(std::span<const RuleResult> results) {
  const Totals totals = count(results);
  if (totals.failed > 0) return Verdict::fail;
  if (totals.not_run > 0 || totals.planned == 0) return Verdict::not_run;
  if (totals.undecided > 0) return Verdict::undecided;
  return totals.passed > 0 ? Verdict::pass : Verdict::not_applicable;
}

}  // namespace gabarit
