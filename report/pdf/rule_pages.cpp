#include "report/pdf/rule_pages.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/pdf/colouring.h"
#include "report/pdf/finding_page.h"
#include "report/pdf/findings_table.h"
#include "report/pdf/histogram_plot.h"
#include "report/pdf/method_page.h"
#include "report/pdf/rule_views.h"
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

// Of pages that single findings have left in this report.
static std::size_t finding_pages(const Book& book, const RuleResult& result, std::size_t left) {
  return std::min({result.findings.size(), book.options->limits.findings_a_rule, left});
}

static void add_chapter(Book& book, const RuleResult& result, std::size_t& pages_left) {
  add_method_page(book, result);
  if (result.verdict == Verdict::not_run || result.verdict == Verdict::not_applicable) return;
  const Colouring colours = colouring(book.model().mesh, result);
  add_views_page(book, result, colours);
  book.flow.begin_page("Rule " + result.rule.id);
  add_histogram(book, result);
  add_findings(book, result);
  const std::size_t pages = finding_pages(book, result, pages_left);
  for (std::size_t i = 0; i < pages; ++i) add_finding_page(book, result, result.findings[i], colours);
  pages_left -= pages;
}

void add_rule_pages(Book& book) {
  std::size_t pages_left = book.options->limits.findings;
  for (const RuleResult* result : book.with_pages) add_chapter(book, *result, pages_left);
}

}  // namespace gabarit::pdf
