#include "report/pdf/rule_views.h"

#include <fmt/format.h>

#include "report/pdf/legend.h"

namespace gabarit::pdf {

namespace {

constexpr double gap = 6, picture_width = (content_width - gap) / 2,
                 picture_height = picture_width / view_aspect;

// The probe's paths, such as that of a column's axis.
std::vector<SceneLine> trace_lines(const Region& region) {
  std::vector<SceneLine> lines;
  for (const Trace& trace : region.traces) {
    for (std::size_t i = 1; i < trace.points.size(); ++i) {
      lines.push_back({trace.points[i - 1], trace.points[i], palette::trace, 2, true});
    }
    if (trace.closed && trace.points.size() > 2) {
      lines.push_back({trace.points.back(), trace.points.front(), palette::trace, 2, true});
    }
  }
  return lines;
}

std::vector<NamedView> views_with_traces(const Book& book, const RuleResult& result) {
  constexpr Area picture{0, 0, picture_width, picture_height};
  const Frame& frame = book.setup_of(result).frame;
  std::vector<NamedView> views = views_for(picture, book.model().mesh, frame);
  Box3d around = book.model().box;
  for (const Trace& trace : result.region.traces) {
    for (const Vec3d& p : trace.points) {
      if (is_finite(p)) around.add(p);
    }
  }
  // The paths lie around the model and are drawn from above only.
  const std::vector<NamedView> wide = views_for(picture, around, frame);
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i].name == "top") views[i] = wide[i];
  }
  return views;
}

std::string caption_of(const NamedView& view, const std::vector<SceneLine>& lines, const RuleResult& result) {
  std::string text = view.name;
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return view.name == "top" && !lines.empty() ? text + ", with the " + result.region.traces.front().name
                                              : text;
}

}  // namespace

std::vector<DrawnView> add_views_page(Book& book, const RuleResult& result, const Colouring& colouring) {
  Flow& flow = book.flow;
  flow.begin_page("Rule " + result.rule.id);
  flow.subheading("Views of the whole model");
  draw_legend(book, result, colouring);
  const std::vector<SceneLine> lines = trace_lines(result.region);
  const std::vector<NamedView> views = views_with_traces(book, result);
  const std::vector<std::uint8_t> marked = marks(book.model().mesh, {&result, 1});
  std::vector<DrawnView> drawn;
  const double top = flow.y() + 1;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::size_t row = i / 2, column = i % 2;
    const double x = margin_left + static_cast<double>(column) * (picture_width + gap);
    const double y = top + static_cast<double>(row) * (picture_height + caption_height + 1.5);
    ModelView view{{x, y, picture_width, picture_height}, views[i].camera, colouring.facets, marked};
    if (views[i].name == "top") view.lines = lines;
    const HPDF_Image image = draw_view(book, view, caption_of(views[i], lines, result));
    drawn.push_back({views[i], image});
  }
  flow.move_to(top + 4 * (picture_height + caption_height + 1.5));
  return drawn;
}

}  // namespace gabarit::pdf
