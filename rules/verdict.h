// The decision rule (ISO 14253-1 in spirit): a limit is met or broken only when the bounds prove it.
#pragma once

#include <cstdint>

#include "checks/region.h"
#include "rules/rule.h"

namespace gabarit {

enum class Verdict : std::uint8_t { pass, fail, undecided, not_applicable, not_run };
const char* name(Verdict verdict);  // "pass", "fail", "undecided", "not_applicable", "not_run"

// The codes of the field files.
enum class FacetVerdict : std::uint8_t { not_examined = 0, pass = 1, fail = 2, undecided = 3 };

// `at least L`: pass when lower >= L, fail when upper < L; `at most L`: pass when upper <= L, fail when lower
// > L; `between`: both. A facet that is only maybe selected never fails: it passes or is undecided.
FacetVerdict judge(double lower, double upper, const Limit& limit, Selected selected);

}  // namespace gabarit
