#include "report/pdf/annex_pages.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "report/pdf/findings_table.h"
#include "report/pdf/table.h"
#include "report/pdf/words.h"

namespace gabarit::pdf {

namespace {

constexpr std::size_t most_sets = 12;  // whose files are printed

void begin_annex(Book& book, const std::string& letter, const std::string& name) {
  const std::string title = fmt::format("Annex {}: {}", letter, name);
  book.flow.begin_page(title);
  book.flow.document().add_bookmark(title);
  book.flow.heading(title);
}

void add_all_rules(Book& book) {
  begin_annex(book, "A", "all rules and findings");
  Table table{.columns = {{"Rule", 55, Column::Align::left, small_strong_text},
                          {"Verdict", 30},
                          {"Failed", 22, Column::Align::right},
                          {"Undecided", 22, Column::Align::right},
                          {"Examined", 22, Column::Align::right},
                          {"Findings", 19, Column::Align::right}},
              .rows = {},
              .most_lines = 2};
  const std::size_t most = book.options->limits.table_rows;
  for (const RuleResult* r : book.by_attention) {
    if (table.rows.size() == most) break;
    table.rows.push_back({{r->rule.id},
                          {"", r->verdict},
                          {count_text(r->facets_failed)},
                          {count_text(r->facets_undecided)},
                          {count_text(r->facets_examined)},
                          {count_text(r->findings.size() + r->findings_ignored)}});
  }
  draw(book.flow, table);
  if (book.by_attention.size() > most)
    book.flow.paragraph(
        fmt::format("… {} in all; every one is in results.json.", counted(book.by_attention.size(), "rule")),
        quiet_text);
}

void add_all_findings(Book& book) {
  std::size_t left = book.options->limits.table_rows;
  for (const RuleResult* result : book.by_attention) {
    if (result->findings.empty()) continue;
    if (left == 0)
      return book.flow.paragraph("The table ends here; every finding is in results.json.", quiet_text);
    book.flow.subheading("Findings of " + result->rule.id);
    add_findings_table(book, *result, left);
    left -= std::min(left, result->findings.size());
  }
}

void add_rule_file(Book& book, const RuleSet& set) {
  begin_annex(book, "B", set.file.empty() ? set.id : set.file);
  book.flow.entry("SHA-256", set.sha256, code_text, 1);
  book.flow.skip(grid_step / 2);
  const std::size_t most = book.options->limits.rule_file_lines;
  const std::vector<std::string> lines = wrap(book.flow.fonts(), set.text, code_text, content_width, most);
  for (const std::string& line : lines) {
    book.flow.need(code_text.leading);
    book.flow.canvas().text({margin_left, book.flow.y() + 0.75 * code_text.leading}, line, code_text);
    book.flow.skip(code_text.leading);
  }
  if (lines.size() == most)
    book.flow.paragraph("The file goes on; its SHA-256 identifies the whole of it.", quiet_text);
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string missing_text(const std::set<char32_t>& missing) {
  std::string text;
  std::size_t shown = 0;
  for (const char32_t code : missing) {
    if (shown++ == 60) return text + fmt::format(", … {} in all", count_text(missing.size()));
    text += fmt::format("{}U+{:04X}", text.empty() ? "" : ", ", static_cast<std::uint32_t>(code));
  }
  return text;
}

void add_settings(Book& book) {
  begin_annex(book, "C", "settings, versions and fonts");
  Flow& flow = book.flow;
  flow.entry("Command", joined(book.report->command_line, " "), code_text, 12);
  flow.entry("Program", "Gabarit " + book.report->version);
  flow.entry("Computed on", book.outcome().device);
  const std::vector<RuleSet>& sets = book.outcome().rulesets;
  for (std::size_t i = 0; i < std::min(sets.size(), most_sets); ++i) {
    flow.entry("Rule set", fmt::format("{} {}", sets[i].id, sets[i].sha256), small_text, 2);
  }
  if (sets.size() > most_sets) {
    flow.entry(
        "",
        fmt::format("… {} in all, the files of the first {} in annex B; results.json identifies every one",
                    counted(sets.size(), "rule set"), most_sets),
        small_text);
  }
  flow.entry("Fonts", joined(flow.fonts().names(), ", "), small_text, 4);
  if (!flow.fonts().missing().empty()) {
    flow.entry("Not shown",
               missing_text(flow.fonts().missing()) +
                   fmt::format(". No font at hand has these characters; each is drawn as {}.",
                               flow.fonts().embedded() ? "□" : "?"),
               small_text, 20);
  }
}

}  // namespace

void add_annex_pages(Book& book) {
  add_all_rules(book);
  add_all_findings(book);
  const std::vector<RuleSet>& sets = book.outcome().rulesets;
  for (std::size_t i = 0; i < std::min(sets.size(), most_sets); ++i) add_rule_file(book, sets[i]);
  add_settings(book);
}

}  // namespace gabarit::pdf
