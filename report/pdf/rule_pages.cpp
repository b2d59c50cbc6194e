#include "report/pdf/rule_pages.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/pdf/colouring.h"
#include "report/pdf/finding_page.h"
#include "report/pdf/findings_table.h"
#include "report/pdf/histogram_plot.h"
#include "report/pdf/method_page.h"
#include "report/pdf/ranges_table.h"
#include "report/pdf/rule_views.h"
#include "report/pdf/words.h"

namespace gabarit::pdf {

static void add_findings(Book& book, const RuleResult& result) {
  book.flow.subheading("Findings, worst first");
  if (result.findings.empty()) {
    return book.flow.paragraph(fmt::format("None listed, of {} and {} examined.",
                                           counted(result.facets_examined, "facet"),
                                           area_text(result.area_examined)));
  }
  add_findings_table(book, result, 40);
  if (result.rule.severity == Severity::note)
    book.flow.paragraph("The rule is a note, for information: its findings have no pages of their own.");
}

static void add_chapter(Book& book, const RuleResult& result) {
  add_method_page(book, result);
  if (!has_pictures(result.verdict)) return;
  const Colouring colours = colouring(book.model().mesh, result, book.options->palette);
  const std::vector<DrawnView> views = add_views_page(book, result, colours);
  book.flow.begin_page("Rule " + result.rule.id);
  add_histogram(book, result);
  add_ranges(book, result);
  add_findings(book, result);
  for (std::size_t i = 0; i < book.finding_pages(result); ++i) {
    add_finding_page(book, result, result.findings[i], colours, views);
  }
}

void add_rule_pages(Book& book) {
  for (const RuleResult* result : book.with_pages) add_chapter(book, *result);
}

}  // namespace gabarit::pdf
