#include "report/pdf/item_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/number_text.h"
#include "report/pdf/model_view.h"
#include "report/pdf/table.h"
#include "report/pdf/words.h"

namespace gabarit::pdf {

namespace {

constexpr std::size_t most_bodies = 24, most_warnings = 8, most_setups = 6;

std::string size_text(const Box3d& box) {
  const Vec3d size = box.extent();
  return fmt::format("{} × {} × {} mm", number_text(size.x), number_text(size.y), number_text(size.z));
}

// In the order in which resolve_setup() takes them.
const char* sag_origin(const Book& book, const RuleSet& set) {
  const std::vector<std::string>& words = book.report->command_line;
  if (std::find(words.begin(), words.end(), "--sag") != words.end()) return "given on the command line";
  if (book.model().sag) return "declared with the model";
  return set.sag ? "from the rule file" : "the default: neither model nor rule file declares one";
}

// The part without any verdict, and how the model's axes lie.
void draw_picture(Book& book) {
  const Area area = book.flow.reserve_right(58, 44);
  const Frame frame = book.outcome().setups.empty() ? Frame() : book.outcome().setups.front().frame;
  draw_view(book, {area, views_for(area, book.model().mesh, frame).at(6).camera, {}}, "The part as loaded");
}

void add_model(Book& book) {
  const Model& model = book.model();
  Flow& flow = book.flow;
  flow.subheading("Item");
  draw_picture(book);
  flow.entry("File", model.file);
  flow.entry("SHA-256", model.sha256, code_text);
  if (!model.format.empty()) flow.entry("Format", model.format);
  flow.entry("Unit of the file",
             fmt::format("{}, {}", name(model.unit),
                         model.unit_declared ? "declared" : "assumed: the file does not say"));
  flow.entry("Facets", count_text(model.mesh.facet_count()));
  flow.entry("Box", model.box.empty()
                        ? "none: nothing is finite"
                        : fmt::format("{} to {} mm", place_text(model.box.min), place_text(model.box.max)));
  flow.entry("Size", size_text(model.box));
}

void add_bodies(Book& book) {
  const std::vector<std::string>& bodies = book.model().bodies;
  std::string names;
  for (std::size_t i = 0; i < std::min(bodies.size(), most_bodies); ++i)
    names += (i > 0 ? ", " : "") + bodies[i];
  if (bodies.size() > most_bodies) names += fmt::format(", … {} in all", count_text(bodies.size()));
  book.flow.entry(bodies.size() == 1 ? "Body" : fmt::format("Bodies ({})", count_text(bodies.size())), names,
                  body_text, 10);
}

void add_defects(Book& book) {
  const Defects& d = book.model().defects;
  Flow& flow = book.flow;
  flow.subheading("Condition of the mesh");
  flow.entry("Watertight", watertight(d) ? "yes" : "no");
  Table table{.columns = {{"Defect", 110}, {"Count", 30, Column::Align::right}}, .rows = {}};
  const auto row = [&](const char* what, std::uint64_t count) {
    table.rows.push_back({{what}, {count_text(count)}});
  };
  row("Facets with a coordinate that is not finite", d.not_finite);
  row("Facets without area", d.degenerate);
  row("Facets over the vertices of an earlier one", d.duplicate);
  row("Open edges (of one facet)", d.open_edges);
  row("Edges of three facets or more", d.non_manifold_edges);
  row("Edges whose two facets are oriented against each other", d.misoriented_edges);
  draw(flow, table);
  const Diagnostics& warnings = book.model().warnings;
  for (std::size_t i = 0; i < std::min(warnings.size(), most_warnings); ++i) {
    flow.entry(i == 0 ? "Warnings" : "", warnings[i].message, body_text, 3);
  }
  if (warnings.size() > most_warnings)
    flow.entry("", fmt::format("… {} in all", counted(warnings.size(), "warning")));
}

const char* axis_name(const Vec3d& d) {
  return d.x > 0.5    ? "+x"
         : d.x < -0.5 ? "-x"
         : d.y > 0.5  ? "+y"
         : d.y < -0.5 ? "-y"
         : d.z > 0.5  ? "+z"
                      : "-z";
}

void add_setup(Book& book) {
  Flow& flow = book.flow;
  flow.subheading("Set-up");
  for (std::size_t i = 0;
       i < std::min({book.outcome().setups.size(), book.outcome().rulesets.size(), most_setups}); ++i) {
    const Setup& setup = book.outcome().setups[i];
    const RuleSet& set = book.outcome().rulesets[i];
    flow.entry("Rule set", set.id);
    flow.entry("Frame",
               fmt::format("up {}, forward {}; ground at {} mm along up ({})", axis_name(setup.frame.up),
                           axis_name(setup.frame.forward), number_text(setup.frame.ground),
                           set.ground == Ground::lowest ? "the lowest point of the model"
                                                        : "given by the rule file"));
    flow.entry("Sag", fmt::format("{}, {}: the true surface is taken to lie no further from the facets",
                                  length_text(setup.sag), sag_origin(book, set)));
  }
  if (book.outcome().setups.size() > most_setups)
    flow.entry("", fmt::format("… {} in all", counted(book.outcome().setups.size(), "rule set")));
  flow.entry("Computed on", book.outcome().device == "cuda" ? "a CUDA device" : "the processor");
}

void add_font_notice(Book& book) {
  Fonts& fonts = book.flow.fonts();
  if (!fonts.embedded()) {
    book.flow.entry("Fonts",
                    "DejaVu Sans was not found on the machine that made this report. Built-in fonts stand "
                    "in; what they cannot show is written as “?”.");
  } else if (!fonts.missing().empty()) {
    book.flow.entry("Fonts",
                    "No font at hand shows some of the characters in the names above; each is drawn as □. "
                    "The annex lists them.");
  }
}

}  // namespace

void add_item_page(Book& book) {
  Flow& flow = book.flow;
  flow.begin_page("Item and set-up");
  flow.document().add_bookmark("Item and set-up");
  flow.heading("Item and set-up");
  add_model(book);
  add_bodies(book);
  add_defects(book);
  add_setup(book);
  add_font_notice(book);
}

}  // namespace gabarit::pdf
