// What the pages of one report share.
#pragma once

#include <vector>

#include "report/pdf/flow.h"
#include "report/report.h"
#include "report/write_pdf.h"

namespace gabarit::pdf {

struct Book {
  Book(const Report& r, const PdfOptions& o, Document& document, Fonts& fonts);

  const Outcome& outcome() const { return *report->outcome; }
  const Model& model() const { return *report->model; }
  const Setup& setup_of(const RuleResult& result) const;

  const Report* report;
  const PdfOptions* options;
  Flow flow;
  // Failed, not run, undecided, passed, not applicable; errors before warnings before notes.
  std::vector<const RuleResult*> by_attention;
  std::vector<const RuleResult*> with_pages;  // as planned; see PdfLimits::rules
};

}  // namespace gabarit::pdf
