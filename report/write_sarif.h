// SARIF 2.1.0 for code hosts and analysis dashboards.
#pragma once

#include <string>

#include "report/report.h"

namespace gabarit {

// A finding is a result: fail with the rule's severity as its level, undecided as kind "open". Rules that
// passed, do not apply or were not run have one result each, so that no rule is silently absent; a rule that
// was not run is also a notification of an unsuccessful invocation. At most 25,000 results, the cap of code
// hosts; what is left out is said in a notification.
std::string sarif_json(const Report& report);

}  // namespace gabarit
