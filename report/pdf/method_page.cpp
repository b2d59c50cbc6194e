#include "report/pdf/method_page.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "report/pdf/badge.h"
#include "report/pdf/sketch.h"
#include "report/pdf/words.h"
#include "rules/region.h"

namespace gabarit::pdf {

std::string decision_text(const Requirement& require) {
  const char* rule = "";
  switch (require.limit.kind) {
    case Limit::Kind::at_least:
      rule =
          "A facet passes when its lower bound is at least the limit and fails when its upper bound is below "
          "it";
      break;
    case Limit::Kind::at_most:
      rule =
          "A facet passes when its upper bound is at most the limit and fails when its lower bound is above "
          "it";
      break;
    case Limit::Kind::between:
      rule =
          "A facet passes when both its bounds lie within the limits and fails when both lie beyond the same "
          "one";
      break;
  }
  return fmt::format(
      "Required: {}. {}; when the limit lies between the bounds it is undecided, and undecided never counts "
      "as "
      "passed. A facet that the rule only maybe looks at does not fail: it passes or is undecided. The "
      "bounds hold "
      "the true value; they are numerical (tessellation, sampling, arithmetic), not a coverage probability. "
      "This "
      "follows ISO 14253-1 in spirit.",
      require.limit_text, rule);
}

namespace {

constexpr std::size_t most_lines = 24;  // of what a rule file or a run may make as long as it likes

// Every use of a selector, in the order of the rule file.
void collect(const Where& where, std::vector<const Where*>& uses) {
  if (where.selector != nullptr) uses.push_back(&where);
  for (const Where& child : where.children) collect(child, uses);
}

bool uses(const Rule& rule, const Selector* selector) {
  std::vector<const Where*> all;
  collect(rule.where, all);
  return std::any_of(all.begin(), all.end(), [&](const Where* w) { return w->selector == selector; });
}

std::string selector_name(const Selector& selector) {
  return selector.variant.empty() ? selector.name : selector.name + ": " + selector.variant;
}

// What an earlier chapter has explained is not repeated.
bool explained_before(const Book& book, const RuleResult& result, const auto& explains) {
  for (const RuleResult* other : book.with_pages) {
    if (other == &result) return false;
    if (explains(other->rule)) return true;
  }
  return false;
}

void add_explanation(Book& book, const std::string& name, const std::string& summary,
                     const std::string& documentation, bool before) {
  Flow& flow = book.flow;
  flow.need(4 * grid_step);
  flow.paragraph(name + (summary.empty() ? "" : " – " + summary), small_strong_text);
  if (before) return flow.paragraph("Explained with an earlier rule of this report.", quiet_text);
  flow.paragraphs(documentation, small_text);
}

void add_selector(Book& book, const RuleResult& result, const Where& use) {
  Flow& flow = book.flow;
  const Selector& selector = *use.selector;
  const bool before = explained_before(book, result, [&](const Rule& rule) { return uses(rule, &selector); });
  if (!before && has_sketch(selector)) {
    flow.pass_reserved();
    draw_sketch(flow.canvas(), flow.reserve_right(sketch_width, sketch_height), selector, use.arguments);
  }
  add_explanation(book, selector_name(selector), selector.summary, selector.documentation, before);
}

void add_where(Book& book, const RuleResult& result) {
  Flow& flow = book.flow;
  flow.subheading("Where the rule looks");
  std::vector<const Where*> all;
  collect(result.rule.where, all);
  flow.paragraph(all.empty() ? "At every facet of the model."
                             : fmt::format("At facets where {}.", describe(result.rule.where)),
                 body_text, most_lines);
  std::vector<const Selector*> done;
  for (const Where* use : all) {
    if (std::find(done.begin(), done.end(), use->selector) != done.end()) continue;
    done.push_back(use->selector);
    add_selector(book, result, *use);
  }
  flow.pass_reserved();
}

// Descriptors say it as a part of a sentence.
std::string as_sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

void add_measure(Book& book, const RuleResult& result) {
  const Measure* const measure = result.rule.require.measure;
  if (measure == nullptr) return;
  Flow& flow = book.flow;
  flow.subheading("What it measures", sketch_height + grid_step);
  const bool before =
      explained_before(book, result, [&](const Rule& rule) { return rule.require.measure == measure; });
  if (!before && has_sketch(*measure))
    draw_sketch(flow.canvas(), flow.reserve_right(sketch_width, sketch_height), *measure);
  if (measure->sentence != nullptr)
    flow.paragraph(as_sentence(measure->sentence(result.rule.require.arguments)));
  add_explanation(book, measure_text(result.rule.require), measure->summary, measure->documentation, before);
  flow.pass_reserved();
}

void add_notes(Book& book, const RuleResult& result) {
  if (result.region.notes.empty() && result.field.notes.empty()) return;
  book.flow.subheading("Notes of this run");
  for (const auto* notes : {&result.region.notes, &result.field.notes}) {
    for (const std::string& note : *notes) book.flow.paragraph(note, small_text, most_lines);
  }
}

void draw_head(Book& book, const RuleResult& result) {
  Flow& flow = book.flow;
  flow.heading(result.rule.title.empty() ? result.rule.id : result.rule.title);
  draw_plate(flow.canvas(), {margin_left, flow.y(), content_width, 9}, result.verdict);
  flow.skip(9 + grid_step);
  flow.entry("Rule", result.rule.id, strong_text, 1);
  if (!result.rule.clause.empty()) flow.entry("Clause", result.rule.clause, body_text, 2);
  flow.entry("Severity", severity_word(result.rule.severity));
  flow.entry("Required", measure_text(result.rule.require) + " " + result.rule.require.limit_text, body_text,
             2);
  flow.entry("Examined", fmt::format("{}, {}", counted(result.facets_examined, "facet"),
                                     area_text(result.area_examined)));
  if (result.facets_failed > 0)
    flow.entry("Failing",
               fmt::format("{}, {}", counted(result.facets_failed, "facet"), area_text(result.area_failed)));
  if (result.facets_undecided > 0)
    flow.entry("Undecided", fmt::format("{}, {}", counted(result.facets_undecided, "facet"),
                                        area_text(result.area_undecided)));
  if (!result.reason.empty()) flow.entry("Reason", result.reason, body_text, 8);
}

}  // namespace

void add_method_page(Book& book, const RuleResult& result) {
  book.flow.begin_page("Rule " + result.rule.id);
  book.flow.document().add_bookmark("Rule " + result.rule.id);
  draw_head(book, result);
  add_where(book, result);
  add_measure(book, result);
  book.flow.subheading("How it decides");
  book.flow.paragraph(decision_text(result.rule.require), small_text);
  add_notes(book, result);
}

}  // namespace gabarit::pdf
