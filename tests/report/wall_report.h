// A report about walls that were really measured, for the tests of pages and statistics.
#pragma once

#include <string>

#include "report/report.h"
#include "tests/shapes.h"

namespace gabarit {

struct WallReport {
  // `measure` is thickness or clearance, `method` one of theirs.
  WallReport(const shapes::Triangles& shape, const Limit& limit, const std::string& measure = "thickness",
             const std::string& method = "wall");
  Report report() const { return make_report(model, outcome); }
  const RuleResult& rule() const { return outcome.results.front(); }

  Model model;
  Outcome outcome;
};

}  // namespace gabarit
