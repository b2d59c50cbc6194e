// JUnit XML for build servers.
#pragma once

#include <string>

#include "report/report.h"

namespace gabarit {

// A rule set is a suite, a rule a test case: fail is a failure; undecided and not run are errors, for neither
// may look like a pass; not applicable is skipped. No times: the same inputs give the same bytes.
std::string junit_xml(const Report& report);

}  // namespace gabarit
