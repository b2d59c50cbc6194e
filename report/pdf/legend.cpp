#include "report/pdf/legend.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/number_text.h"
#include "report/pdf/words.h"

namespace gabarit::pdf {

namespace {

struct Entry {
  Rgb colour;
  std::string text;
};

// "touched and too sharp", in the words of the rule.
std::vector<Entry> verdict_entries(const RuleResult& result) {
  const bool contact = !result.region.depth.empty();
  const Measure* const measure = result.rule.require.measure;
  const bool round = measure != nullptr && measure->name == "radius";
  const std::string looked = contact ? "touched" : "examined";
  const std::size_t passed = result.facets_examined - result.facets_failed - result.facets_undecided;
  return {
      {palette::fail, fmt::format("{} and {} ({})", looked, round ? "too sharp" : "failing",
                                  count_text(result.facets_failed))},
      {palette::undecided, fmt::format("undecided ({})", count_text(result.facets_undecided))},
      {palette::pass, fmt::format("{} and {} ({})", looked, round ? "round" : "passing", count_text(passed))},
      {palette::out_of_reach, contact ? "out of reach" : "not examined"}};
}

void draw_entries(Flow& flow, const std::vector<Entry>& entries) {
  Canvas& canvas = flow.canvas();
  double x = margin_left;
  for (const Entry& entry : entries) {
    const Area swatch{x, flow.y() + 0.6, 4, 3};
    canvas.fill(swatch, entry.colour);
    canvas.frame(swatch, soft, 0.15);
    canvas.text({x + 5.5, flow.y() + 3.1}, entry.text, small_text);
    x += 5.5 + canvas.width(entry.text, small_text) + 6;
  }
  flow.skip(5.5);
}

double share(const ColourScale& scale, double value) {
  return std::clamp((value - scale.low) / (scale.high - scale.low), 0.0, 1.0);
}

void mark_limit(Canvas& canvas, const Area& bar, const ColourScale& scale, double limit,
                const std::string& unit) {
  const double x = bar.x + bar.width * share(scale, limit);
  canvas.line({x, bar.y - 1.2}, {x, bar.y + bar.height + 1.2}, ink, 0.5);
  canvas.text_centred({x, bar.y - 2}, "limit " + number_text(limit) + " " + unit, small_strong_text);
}

void draw_scale(Flow& flow, const RuleResult& result, const ColourScale& scale) {
  Canvas& canvas = flow.canvas();
  const std::string unit = unit_text(result.rule.require);
  const Area bar{margin_left + 25, flow.y() + 5, content_width - 50, 4};
  constexpr int steps = 120;
  for (int i = 0; i < steps; ++i) {
    const double middle = scale.low + (scale.high - scale.low) * (i + 0.5) / steps;
    canvas.fill({bar.x + bar.width * i / steps, bar.y, bar.width / steps + 0.05, bar.height},
                scale.colour(middle));
  }
  canvas.frame(bar, soft, 0.15);
  canvas.text_right({bar.x - 2, bar.y + 3}, number_text(scale.low) + " " + unit, small_text);
  canvas.text({bar.x + bar.width + 2, bar.y + 3}, "≥ " + number_text(scale.high) + " " + unit, small_text);
  if (scale.limit && scale.limit->kind != Limit::Kind::at_most)
    mark_limit(canvas, bar, scale, scale.limit->low, unit);
  if (scale.limit && scale.limit->kind != Limit::Kind::at_least)
    mark_limit(canvas, bar, scale, scale.limit->high, unit);
  flow.skip(11.5);
}

}  // namespace

void draw_legend(Book& book, const RuleResult& result, const Colouring& colouring) {
  if (!colouring.by_value) return draw_entries(book.flow, verdict_entries(result));
  draw_scale(book.flow, result, colouring.scale);
  draw_entries(book.flow,
               {{palette::undecided, fmt::format("undecided ({})", count_text(result.facets_undecided))},
                {palette::no_value, "no value"},
                {palette::out_of_reach, "not examined"}});
}

}  // namespace gabarit::pdf
