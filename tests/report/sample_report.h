// A report with one rule of every verdict, built by hand over a small box.
#pragma once

#include <string>

#include "report/report.h"

namespace gabarit {

class SampleReport {
 public:
  SampleReport();
  Report report() const { return make_report(model, outcome); }
  RuleResult& rule(const std::string& id);

  Model model;
  Outcome outcome;
};

// A rule that asks for a radius of at least 4 mm.
RuleResult sample_result(const std::string& id, Verdict verdict);

}  // namespace gabarit
