#include "rules/verdict.h"

namespace gabarit {

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass: return "pass";
    case Verdict::fail: return "fail";
    case Verdict::undecided: return "undecided";
    case Verdict::not_applicable: return "not_applicable";
    case Verdict::not_run: break;
  }
  return "not_run";
}

FacetVerdict judge(double lower, double upper, const Limit& limit, Selected selected) {
  if (selected == Selected::no) return FacetVerdict::not_examined;
  const bool floor = limit.kind != Limit::Kind::at_most;
  const bool ceiling = limit.kind != Limit::Kind::at_least;
  const bool broken = (floor && upper < limit.low) || (ceiling && lower > limit.high);
  const bool met = (!floor || lower >= limit.low) && (!ceiling || upper <= limit.high);  // NaN meets nothing
  if (broken) return selected == Selected::yes ? FacetVerdict::fail : FacetVerdict::undecided;
  return met ? FacetVerdict::pass : FacetVerdict::undecided;
}

}  // namespace gabarit
