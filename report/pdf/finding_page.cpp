#include "report/pdf/finding_page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/finding_text.h"
#include "report/pdf/badge.h"
#include "report/pdf/ball_section.h"
#include "report/pdf/words.h"

namespace gabarit::pdf {

namespace {

constexpr double close_up_height = 122, place_width = 98;  // mm
// With a section: a lower close-up, below it the section on the left and the place on the right.
constexpr double low_close_up_height = 84, section_width = 98, section_height = 104,
                 right_column = margin_left + section_width + 6,
                 right_width = content_width - section_width - 6;
constexpr double close_up_share = 0.8;  // of the resolution: it shows few facets

// Wide enough to hold the finding when that still shows it, never so near that nobody knows the place.
double close_up_extent(const Box3d& model, const Box3d& finding) {
  const double whole = length(model.extent());
  return std::clamp(2 * length(finding.extent()), whole / 24, whole / 3);
}

void draw_number(Book& book, const RuleResult& result, const Finding& finding) {
  Flow& flow = book.flow;
  const Requirement& require = result.rule.require;
  const std::string value = measured_text(finding.worst.value, require);
  const TextStyle large = shrunk(flow.fonts(), value, {Face::bold, 22, verdict_colour(finding.verdict)}, 80);
  flow.canvas().text({margin_left, flow.y() + 8}, value, large);
  const double x = margin_left + flow.canvas().width(value, large) + 5, width = page_width - margin_right - x;
  flow.canvas().text({x, flow.y() + 3.8},
                     fitted(flow.fonts(), "required: " + require.limit_text, strong_text, width),
                     strong_text);
  flow.canvas().text(
      {x, flow.y() + 8},
      fitted(flow.fonts(),
             fmt::format("bounds {} {}", bounds_text(finding.worst, require), unit_text(require)), quiet_text,
             width),
      quiet_text);
  flow.skip(12.5);
}

// Where the pictures look: the worst place, or the middle of what is known when that is not finite.
Vec3d focus(const Book& book, const Finding& finding) {
  if (is_finite(finding.worst.at)) return finding.worst.at;
  if (is_finite(finding.centroid)) return finding.centroid;
  return book.model().box.empty() ? Vec3d{} : book.model().box.centre();
}

void draw_close_up(Book& book, const RuleResult& result, const Finding& finding, const Colouring& colouring,
                   double height) {
  Flow& flow = book.flow;
  const TriangleMesh& mesh = book.model().mesh;
  std::vector<std::uint8_t> emphasis(mesh.facet_count(), 0);
  for (const FacetId f : finding.facets) emphasis[f] = 1;
  const Vec3d outward = facet_normal(mesh, finding.worst.facet);
  const std::vector<std::uint8_t> marked = marks(mesh, {&result, 1});
  ModelView view{{margin_left, flow.y(), content_width, height}, {}, colouring.facets, marked};
  view.camera = close_up(focus(book, finding), outward, book.setup_of(result).frame,
                         close_up_extent(book.model().box, finding.box), content_width / height);
  view.emphasis = emphasis;
  view.share = close_up_share;
  draw_view(book, view, "Close-up: in full colour the facets of this finding, ringed the worst place");
  mark_place(book, view, finding.worst.at, 4);
  flow.skip(height + caption_height + 2.5);
}

// The fixed view that looks at the place most squarely.
const DrawnView& facing_view(const Book& book, const Finding& finding, const std::vector<DrawnView>& views) {
  const Vec3d outward = facet_normal(book.model().mesh, finding.worst.facet);
  const auto squarely = [&](const DrawnView& drawn) { return dot(drawn.view.camera.toward(), outward); };
  return *std::max_element(views.begin(), views.end(),
                           [&](const DrawnView& a, const DrawnView& b) { return squarely(a) < squarely(b); });
}

void draw_place(Book& book, Place at, double width, const Finding& finding,
                const std::vector<DrawnView>& views) {
  const DrawnView& facing = facing_view(book, finding, views);
  ModelView view{{at.x, at.y, width, width / view_aspect}, facing.view.camera, {}};
  view.image = facing.image;
  draw_view(book, view, "Place on the part, " + facing.view.name);
  mark_place(book, view, finding.worst.at, 3);
}

struct Fact {
  const char* name;
  std::string value;
};

std::vector<Fact> facts(const Book& book, const RuleResult& result, const Finding& f) {
  const Frame& frame = book.setup_of(result).frame;
  std::vector<Fact> list{
      {"Place, model", place_text(f.worst.at) + " mm"},
      {"Place, vehicle", place_text(frame.to_vehicle(f.worst.at)) + " mm"},
      {"Facet", fmt::format("{}, counted from 0", f.worst.facet)},
      {"Area", fmt::format("{} in {}", area_text(f.area), counted(f.facets.size(), "facet"))},
      {"Box, from", place_text(f.box.min) + " mm"},
      {"Box, to", place_text(f.box.max) + " mm"}};
  if (!(f.worst.contact == f.worst.at) && is_finite(f.worst.contact))
    list.push_back({"Other end", place_text(f.worst.contact) + " mm"});
  if (!f.body.empty()) list.push_back({"Body", f.body});
  if (const std::string face = face_text(book.model(), f.worst.facet); !face.empty())
    list.push_back({"Worst on", face});
  if (const std::string faces = faces_text(f); !faces.empty()) list.push_back({"Reaches over", faces});
  list.push_back({"Rule", result.rule.id});
  if (!result.rule.clause.empty()) list.push_back({"Clause", result.rule.clause});
  list.push_back({"Facets in", f.verdict == Verdict::fail ? "violations/" + result.rule.id + ".stl"
                                                          : "no STL: it holds failing facets only"});
  return list;
}

void draw_facts(Book& book, Place at, const std::vector<Fact>& list) {
  Flow& flow = book.flow;
  const double x = at.x, value_x = x + 22, width = page_width - margin_right - value_x;
  double y = at.y + 2.8;
  for (const Fact& fact : list) {
    flow.canvas().text({x, y}, fact.name, label_text);
    for (const std::string& line : wrap(flow.fonts(), fact.value, small_text, width, 2)) {
      flow.canvas().text({value_x, y}, line, small_text);
      y += small_text.leading;
    }
    y += 1.2;
  }
  flow.canvas().text({x, y + 1},
                     fitted(flow.fonts(), "Vehicle: x rearward, y right, z above ground", label_text,
                            page_width - margin_right - x),
                     label_text);
}

}  // namespace

void add_finding_page(Book& book, const RuleResult& result, const Finding& finding,
                      const Colouring& colouring, const std::vector<DrawnView>& views) {
  Flow& flow = book.flow;
  flow.begin_page("Finding " + finding.id);
  flow.heading("Finding " + finding.id);
  flow.skip(1.5);
  draw_small_badge(flow.canvas(), {margin_left, flow.y()}, finding.verdict);
  const TextStyle rule_title = quiet_text;
  flow.canvas().text({margin_left + 30, flow.y() - 1},
                     fitted(flow.fonts(), result.rule.title, rule_title, content_width - 30), rule_title);
  flow.skip(3.5);
  draw_number(book, result, finding);
  const auto ball = worst_ball(book.model().mesh, result, finding.worst);
  draw_close_up(book, result, finding, colouring, ball ? low_close_up_height : close_up_height);
  const double y = flow.y();
  if (ball) {
    draw_ball_section(book, {margin_left, y, section_width, section_height}, result, *ball);
    draw_place(book, {right_column, y}, right_width, finding, views);
    const double below = y + right_width / view_aspect + caption_height + 1.5;
    return draw_facts(book, {right_column, below}, facts(book, result, finding));
  }
  draw_place(book, {margin_left, y}, place_width, finding, views);
  draw_facts(book, {margin_left + place_width + 6, y}, facts(book, result, finding));
}

}  // namespace gabarit::pdf
