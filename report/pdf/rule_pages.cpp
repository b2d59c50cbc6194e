#include "report/pdf/rule_pages.h"

#include <fmt/format.h>

#include "report/pdf/findings_table.h"
#include "report/pdf/method_page.h"
#include "report/pdf/words.h"

namespace gabarit::pdf {

static void add_findings(Book& book, const RuleResult& result) {
  if (result.verdict == Verdict::not_run || result.verdict == Verdict::not_applicable) return;
  book.flow.subheading("Findings, worst first");
  if (result.findings.empty()) {
    return book.flow.paragraph(fmt::format("None listed, of {} and {} examined.",
                                           counted(result.facets_examined, "facet"),
                                           area_text(result.area_examined)));
  }
  add_findings_table(book, result, 40);
}

void add_rule_pages(Book& book) {
  for (const RuleResult* result : book.with_pages) {
    add_method_page(book, *result);
    add_findings(book, *result);
  }
}

}  // namespace gabarit::pdf
