#include "report/pdf/findings_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/finding_text.h"
#include "report/number_text.h"
#include "report/pdf/table.h"
#include "report/pdf/words.h"

namespace gabarit::pdf {

static Row finding_row(const Finding& f, const Requirement& require) {
  return {{f.body.empty() ? f.id : f.id + "\n" + f.body},
          {"", f.verdict},
          {value_text(f.worst.value, require)},
          {bounds_text(f.worst, require)},
          {place_text(f.worst.at)},
          {area_number(f.area)},
          {count_text(f.facets.size())}};
}

void add_findings_table(Book& book, const RuleResult& result, std::size_t most) {
  const std::string unit = unit_text(result.rule.require);
  Table table{.columns = {{"Finding", 29},
                          {"Verdict", 25},
                          {"Worst" + (unit.empty() ? "" : ", " + unit), 19, Column::Align::decimal},
                          {"Bounds", 27},
                          {"Place, mm", 39},
                          {"Area, mm²", 17, Column::Align::decimal},
                          {"Facets", 14, Column::Align::right}},
              .rows = {},
              .most_lines = 2};
  const std::size_t shown = std::min(most, result.findings.size());
  for (std::size_t i = 0; i < shown; ++i)
    table.rows.push_back(finding_row(result.findings[i], result.rule.require));
  if (!table.rows.empty()) draw(book.flow, table);
  if (shown < result.findings.size()) {
    book.flow.paragraph(
        fmt::format("… {} in all; every one is in results.json.", counted(result.findings.size(), "finding")),
        quiet_text);
  }
  if (result.findings_ignored > 0) {
    book.flow.paragraph(fmt::format("{} smaller than {} are not listed; their facets are counted.",
                                    count_text(result.findings_ignored), area_text(result.rule.ignore_area)),
                        quiet_text);
  }
}

}  // namespace gabarit::pdf
