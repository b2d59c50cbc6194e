// results.json: everything that a program wants to know about a run, without a clock, a host or a thread
// count.
#pragma once

#include <string>

#include "report/report.h"

namespace gabarit {

// The keys and their order are those of docs/results-format.md. Numbers read back to the same bits; what is
// not finite is null.
std::string results_json(const Report& report);

}  // namespace gabarit
