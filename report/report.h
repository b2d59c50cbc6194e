// Everything that a report says, as plain data; the writers only lay it out.
#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "rules/outcome.h"

namespace gabarit {

struct Report {
  const Model* model = nullptr;
  const Outcome* outcome = nullptr;
  std::string id;       // 12 hexadecimal digits: hash of model, rule sets, settings and program version
  std::string version;  // of the program
  std::string date;     // ISO 8601 from SOURCE_DATE_EPOCH; empty when that is not set: no clock in a report
  std::vector<std::string> command_line;  // settings that change the result, no paths of the machine
};

Report make_report(const Model& model, const Outcome& outcome);

}  // namespace gabarit
