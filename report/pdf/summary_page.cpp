#include "report/pdf/summary_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/finding_text.h"
#include "report/pdf/badge.h"
#include "report/pdf/table.h"
#include "report/pdf/words.h"

namespace gabarit::pdf {

namespace {

// The number that decides, large, and what it has to keep.
void draw_number(Book& book, const RuleResult& result) {
  Flow& flow = book.flow;
  Canvas& canvas = flow.canvas();
  const Requirement& require = result.rule.require;
  const double y = flow.y();
  const std::string value = measured_text(result.worst.value, require);
  const TextStyle large = shrunk(flow.fonts(), value, {Face::bold, 26, verdict_colour(result.verdict)}, 75);
  canvas.text({margin_left, y + 9.5}, value, large);
  canvas.text({margin_left, y + 15.5}, fitted(flow.fonts(), "worst " + measure_text(require), quiet_text, 75),
              quiet_text);
  const double x = margin_left + 80, width = content_width - 80;
  const auto row = [&](int i, const char* name, const std::string& text, const TextStyle& style) {
    const double line = y + 4 + i * grid_step;
    canvas.text({x, line}, name, label_text);
    canvas.text({x + 22, line}, fitted(flow.fonts(), text, style, width - 22), style);
  };
  row(0, "Rule", result.rule.id, strong_text);
  row(1, "Required", require.limit_text, body_text);
  row(2, "Bounds", bounds_text(result.worst, require) + " " + unit_text(require), body_text);
  row(3, "Place", place_text(result.worst.at) + " mm, facet " + std::to_string(result.worst.facet),
      body_text);
  flow.skip(20 + grid_step);
}

Row table_row(const RuleResult& result) {
  const Requirement& require = result.rule.require;
  const std::string name =
      result.rule.title.empty() ? result.rule.id : result.rule.id + "\n" + result.rule.title;
  Row row{{"", result.verdict}, {name}};
  if (result.has_worst) {
    row.insert(row.end(), {{measured_text(result.worst.value, require)},
                           {bounds_text(result.worst, require)},
                           {require.limit_text},
                           {place_text(result.worst.at)}});
  } else {
    row.insert(row.end(), {{"–"}, {"–"}, {require.limit_text}, {"–"}});
  }
  row.push_back({count_text(result.facets_failed) + " of " + count_text(result.facets_examined)});
  return row;
}

Table rule_table() {
  return {.columns = {{"Verdict", 31},
                      {"Rule", 42},
                      {"Worst", 19, Column::Align::decimal},
                      {"Bounds", 20},
                      {"Required", 20},
                      {"Place, mm", 22},
                      {"Facets failing", 16}},
          .rows = {},
          .most_lines = 3};
}

// As many rules as leave `reserve` mm of the page free.
std::size_t draw_table(Book& book, double reserve) {
  Table table = rule_table();
  for (const RuleResult* result : book.by_attention) {
    table.rows.push_back(table_row(*result));
    if (height(book.flow.fonts(), table) + reserve > book.flow.room()) {
      table.rows.pop_back();
      break;
    }
    if (table.rows.size() == 60) break;  // no page holds more
  }
  draw(book.flow, table);
  return table.rows.size();
}

void draw_not_run(Book& book) {
  std::string text;
  std::size_t count = 0;
  for (const RuleResult& result : book.outcome().results) {
    if (result.verdict != Verdict::not_run) continue;
    if (++count <= 3)
      text += fmt::format("{}{}: {}", text.empty() ? "" : "  ", result.rule.id, result.reason);
  }
  if (count > 3) text += fmt::format("  … {} in all.", count_text(count));
  book.flow.entry("Not run", count == 0 ? "None: every planned rule was run." : text, body_text, 3);
}

}  // namespace

void add_summary_page(Book& book) {
  Flow& flow = book.flow;
  flow.begin_page("Summary");
  flow.document().add_bookmark("Summary");
  flow.heading("Summary");
  draw_plate(flow.canvas(), {margin_left, flow.y(), content_width, 11}, book.outcome().verdict);
  flow.skip(11 + grid_step);
  flow.paragraph(overall_sentence(book.outcome()), strong_text);
  const auto deciding = std::find_if(book.by_attention.begin(), book.by_attention.end(),
                                     [](const RuleResult* r) { return r->has_worst; });
  if (deciding != book.by_attention.end()) draw_number(book, **deciding);
  const std::size_t total = book.by_attention.size();
  const std::size_t shown = draw_table(book, 44);
  if (shown < total) {
    flow.paragraph(fmt::format("{} of {} shown, those that need attention first; all are in the annex.",
                               count_text(shown), counted(total, "rule")),
                   quiet_text);
  }
  flow.entry("Rules", totals_sentence(book.outcome().totals) + ".", body_text, 2);
  draw_not_run(book);
  flow.entry("Waived", book.outcome().totals.waived == 0 ? "None." : count_text(book.outcome().totals.waived),
             body_text, 1);
}

}  // namespace gabarit::pdf
