// What the pages of one report share.
#pragma once

#include <map>
#include <vector>

#include "report/pdf/flow.h"
#include "report/report.h"
#include "report/write_pdf.h"

namespace gabarit::pdf {

// A rule that was run to an end on something has pictures and a distribution.
constexpr bool has_pictures(Verdict verdict) {
  return verdict != Verdict::not_run && verdict != Verdict::not_applicable;
}

struct Book {
  Book(const Report& r, const PdfOptions& o, Document& document, Fonts& fonts);

  const Outcome& outcome() const { return *report->outcome; }
  const Model& model() const { return *report->model; }
  const Setup& setup_of(const RuleResult& result) const;
  // How many of a rule's findings have a page of their own.
  std::size_t finding_pages(const RuleResult& result) const;

  const Report* report;
  const PdfOptions* options;
  Flow flow;
  // Failed, not run, undecided, passed, not applicable; errors before warnings before notes.
  std::vector<const RuleResult*> by_attention;
  std::vector<const RuleResult*> with_pages;  // as planned; see PdfLimits::rules
  double resolution = 0;                      // of the pictures, dots an inch; see PdfOptions

 private:
  std::map<const RuleResult*, std::size_t> finding_pages_;
};

}  // namespace gabarit::pdf
