#include "report/pdf/histogram_plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/distribution.h"
#include "report/number_text.h"
#include "report/palette.h"
#include "report/pdf/words.h"
#include "report/ticks.h"

namespace gabarit::pdf {

namespace {

constexpr double plot_height = 52;  // mm, without the labels of the axis

struct Plot {
  Area area;                           // inside the axes
  double low = 0, high = 1, most = 1;  // values along x; mm² at the top

  double x(double value) const { return area.x + area.width * (value - low) / (high - low); }
  double y(double mm2) const { return area.y + area.height * (1 - mm2 / most); }
};

void draw_axes(Canvas& canvas, const Plot& plot, const std::string& quantity) {
  const double bottom = plot.area.y + plot.area.height, right = plot.area.x + plot.area.width;
  const Ticks along = ticks(plot.low, plot.high, 10), up = ticks(0, plot.most, 5);
  for (const double value : up.values) {
    canvas.line({plot.area.x, plot.y(value)}, {right, plot.y(value)}, hairline, 0.15);
    canvas.text_right({plot.area.x - 2, plot.y(value) + 1},
                      up.decimals > 0 ? up.text(value) : grouped(up.text(value)), label_text);
  }
  canvas.line({plot.area.x, bottom}, {right, bottom}, ink, 0.3);
  for (const double value : along.values) {
    canvas.line({plot.x(value), bottom}, {plot.x(value), bottom + 1.2}, ink, 0.2);
    canvas.text_centred({plot.x(value), bottom + 4.2}, along.text(value), label_text);
  }
  canvas.text({plot.area.x, plot.area.y - 6.5}, "examined area, mm²", label_text);
  canvas.text_right({right, bottom + 8}, quantity, label_text);
}

void draw_bars(Canvas& canvas, const Plot& plot, const Histogram& h) {
  const double bottom = plot.area.y + plot.area.height;
  for (const HistogramBin& bin : h.bins) {
    if (!(bin.area > 0)) continue;
    const double left = plot.x(bin.from), right = plot.x(bin.to),
                 top = std::min(plot.y(bin.area), bottom - 0.25);
    canvas.fill({left + 0.12, top, std::max(0.3, right - left - 0.24), bottom - top},
                bin.critical ? palette::fail : accent);
  }
}

void draw_limit(Canvas& canvas, const Plot& plot, double limit, const std::string& unit) {
  const double x = plot.x(limit), bottom = plot.area.y + plot.area.height;
  canvas.dashed_line({x, plot.area.y - 3}, {x, bottom}, ink, 0.35);
  const std::string text = "limit " + number_text(limit) + (unit.empty() ? "" : " " + unit);
  const bool left = x > plot.area.x + 0.8 * plot.area.width;
  left ? canvas.text_right({x - 1, plot.area.y - 2.5}, text, small_strong_text)
       : canvas.text({x + 1, plot.area.y - 2.5}, text, small_strong_text);
}

}  // namespace

void add_histogram(Book& book, const RuleResult& result) {
  const std::optional<Histogram> h = distribution(result, book.model().mesh);
  if (!h) return;
  const Limit limit = displayed(result.rule.require.limit, display_factor(result.rule.require));
  Flow& flow = book.flow;
  flow.need(plot_height + 30);
  flow.subheading("Distribution");
  Plot plot{{margin_left + 16, flow.y() + 8, content_width - 18, plot_height}, h->low(), h->high(), 0};
  for (const HistogramBin& bin : h->bins) plot.most = std::max(plot.most, bin.area);
  plot.most = plot.most > 0 ? plot.most * 1.05 : 1;
  const std::string unit = unit_text(result.rule.require);
  draw_axes(flow.canvas(), plot, measure_text(result.rule.require) + (unit.empty() ? "" : ", " + unit));
  draw_bars(flow.canvas(), plot, *h);
  if (limit.kind != Limit::Kind::at_most) draw_limit(flow.canvas(), plot, limit.low, unit);
  if (limit.kind != Limit::Kind::at_least) draw_limit(flow.canvas(), plot, limit.high, unit);
  flow.skip(8 + plot_height + 11);
}

}  // namespace gabarit::pdf
