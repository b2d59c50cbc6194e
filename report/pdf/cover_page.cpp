#include "report/pdf/cover_page.h"

#include <fmt/format.h>

#include "report/finding_text.h"
#include "report/pdf/badge.h"
#include "report/pdf/colouring.h"
#include "report/pdf/model_view.h"
#include "report/pdf/words.h"

namespace gabarit::pdf {

namespace {

constexpr std::size_t most_sets = 3;  // listed on the cover

std::string cover_title(const Book& book) {
  const std::vector<RuleSet>& sets = book.outcome().rulesets;
  if (sets.size() == 1) return sets[0].title.empty() ? sets[0].id : sets[0].title;
  return "Geometric safety check against " + counted(sets.size(), "rule set");
}

void draw_head(Book& book) {
  Canvas& canvas = book.flow.canvas();
  canvas.fill({0, 0, page_width, 4}, accent);
  canvas.text({margin_left, 24}, "GABARIT", {Face::bold, 10, accent});
  canvas.text_right({page_width - margin_right, 24}, "Geometric safety check", quiet_text);
  double y = 42;
  for (const std::string& line : wrap(book.flow.fonts(), cover_title(book), title_text, content_width, 3)) {
    canvas.text({margin_left, y}, line, title_text);
    y += title_text.leading;
  }
  const TextStyle part{Face::regular, 12, soft};
  canvas.text({margin_left, y}, fitted(book.flow.fonts(), book.model().file, part, content_width), part);
  book.flow.move_to(y + 8);
}

// The worst of the first rule that needs attention.
void draw_deciding_number(Book& book) {
  for (const RuleResult* result : book.by_attention) {
    if (!result->has_worst) continue;
    return book.flow.paragraph(
        result->rule.id + ": " + worst_sentence(result->worst, result->rule.require) + ".", body_text, 2);
  }
}

void draw_verdict(Book& book) {
  Flow& flow = book.flow;
  draw_plate(flow.canvas(), {margin_left, flow.y(), content_width, 16}, book.outcome().verdict);
  flow.skip(16 + grid_step);
  flow.paragraph(overall_sentence(book.outcome()), {Face::bold, 10.5});
  flow.paragraph(totals_sentence(book.outcome().totals) + ".");
  draw_deciding_number(book);
}

// The entries below the picture stand at the bottom of the page.
double picture_bottom(const Book& book) {
  const std::size_t sets = std::min(book.outcome().rulesets.size(), most_sets + 1);
  return content_bottom - 32 - 18.5 * static_cast<double>(sets);
}

// The part from the front left above, coloured by the gravest verdict of all rules.
void draw_picture(Book& book) {
  const Area area{margin_left, book.flow.y() + 1, content_width, picture_bottom(book) - book.flow.y() - 1};
  const Frame frame = book.outcome().setups.empty() ? Frame() : book.outcome().setups.front().frame;
  const std::vector<Rgb> colours = verdict_colours(book.model().mesh, book.outcome());
  const NamedView view = views_for(area, book.model().mesh, frame).at(6);
  const std::vector<std::uint8_t> marked = marks(book.model().mesh, book.outcome().results);
  draw_view(book, {area, view.camera, colours, marked},
            "Over all rules – red: fails; amber: undecided; green: passes; blue-grey: not examined");
}

std::string source_text(const RuleSet& set) {
  std::string text = set.source.document;
  for (const std::string* part : {&set.source.edition, &set.source.status}) {
    if (!part->empty()) text += (text.empty() ? "" : ", ") + *part;
  }
  return text.empty() ? "not named in the rule file" : text;
}

void draw_rule_sets(Book& book) {
  const std::vector<RuleSet>& sets = book.outcome().rulesets;
  for (std::size_t i = 0; i < std::min(sets.size(), most_sets); ++i) {
    const RuleSet& set = sets[i];
    book.flow.entry("Regulation", source_text(set), small_text, 2);
    book.flow.entry("Rule set", set.revision.empty() ? set.id : set.id + ", revision " + set.revision,
                    small_text, 1);
    book.flow.entry("SHA-256 of the rules", set.sha256, code_text, 1);
  }
  if (sets.size() > most_sets)
    book.flow.entry("", fmt::format("… {} in all, see the annex", counted(sets.size(), "rule set")),
                    small_text);
}

}  // namespace

void add_cover_page(Book& book) {
  Flow& flow = book.flow;
  flow.begin_bare_page();
  flow.document().add_bookmark("Cover");
  draw_head(book);
  draw_verdict(book);
  draw_picture(book);
  flow.move_to(picture_bottom(book) + 8);
  flow.entry("Report", book.report->id, {Face::bold, 8, ink, 3.75}, 1);
  flow.entry("Part", book.model().file, small_text, 2);
  flow.entry("SHA-256 of the part", book.model().sha256, code_text, 1);
  draw_rule_sets(book);
  flow.entry("Program", "Gabarit " + book.report->version, small_text, 1);
  if (!book.report->date.empty()) flow.entry("Date", book.report->date, small_text, 1);
}

}  // namespace gabarit::pdf
