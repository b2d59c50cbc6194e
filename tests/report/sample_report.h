// A report with one rule of every verdict, built by hand over a small box.
#pragma once

#include <string>

#include "report/report.h"

namespace gabarit {

class SampleReport {
 public:
  SampleReport();
  Report report() const { return make_report(model, outcome); }
  // Makes the model an exact one with two plane faces: 1, called "Deckfläche", under facet 0, and 0
  // elsewhere.
  void add_exact_faces();
  RuleResult& rule(const std::string& id);

  Model model;
  Outcome outcome;
};

// A rule that asks for a radius of at least 4 mm.
RuleResult sample_result(const std::string& id, Verdict verdict);

}  // namespace gabarit
