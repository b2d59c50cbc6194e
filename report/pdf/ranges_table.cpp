#include "report/pdf/ranges_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/distribution.h"
#include "report/number_text.h"
#include "report/pdf/ball_section.h"
#include "report/pdf/model_view.h"
#include "report/pdf/table.h"
#include "report/pdf/words.h"

namespace gabarit::pdf {

namespace {

constexpr double tables_width = 92, section_size = content_width - tables_width - 6;  // mm

std::string percent(double share) { return fmt::format("{:.1f} %", 100 * share); }

std::string range_text(const ValueRange& range) {
  if (!range.from) return "under " + number_text(*range.to);
  if (!range.to) return "over " + number_text(*range.from);
  return number_text(*range.from) + " to " + number_text(*range.to);
}

Table range_table(const Histogram& h, const RuleResult& result, const Limit& limit) {
  const std::string unit = unit_text(result.rule.require);
  Table table{.columns = {{measure_text(result.rule.require) + (unit.empty() ? "" : ", " + unit), 34},
                          {"Area, mm²", 22, Column::Align::right},
                          {"Share", 16, Column::Align::right},
                          {"Limit", 20}},
              .rows = {},
              .most_lines = 1};
  for (const ValueRange& range : value_ranges(h, limit))
    table.rows.push_back({{range_text(range)},
                          {area_number(range.area)},
                          {percent(range.share)},
                          {range.critical ? "beyond" : "within"}});
  if (h.area_without > 0)
    table.rows.push_back(
        {{"no value"}, {area_number(h.area_without)}, {percent(h.share(h.area_without))}, {"undecided"}});
  return table;
}

Table figure_table(const Histogram& h, const RuleResult& result) {
  const std::string unit = unit_text(result.rule.require);
  const auto value = [&](double v) {
    return std::isfinite(v) ? number_text(v) + " " + unit : number_text(v);
  };
  const auto area = [&](double mm2) { return fmt::format("{} ({})", area_text(mm2), percent(h.share(mm2))); };
  return {.columns = {{"Over the examined area", 46}, {"", 46}},
          .rows = {{{"Least"}, {value(h.minimum)}},
                   {{"Greatest"}, {value(h.maximum)}},
                   {{"Mean by area, finite values"}, {value(h.mean)}},
                   {{"Critical area, by value"}, {area(h.critical_area)}},
                   {{"Failing, by its bounds"}, {area(result.area_failed)}},
                   {{"Undecided"}, {area(result.area_undecided)}}},
          .most_lines = 1};
}

}  // namespace

void add_ranges(Book& book, const RuleResult& result) {
  const std::optional<Histogram> h = coarse_distribution(result, book.model().mesh);
  if (!h) return;
  Flow& flow = book.flow;
  const Limit limit = displayed(result.rule.require.limit, display_factor(result.rule.require));
  const Table ranges = range_table(*h, result, limit), figures = figure_table(*h, result);
  flow.need(height(flow.fonts(), ranges) + height(flow.fonts(), figures) + 3 * grid_step);
  const double top = flow.y();
  draw(flow, ranges);
  draw(flow, figures);
  const auto ball = result.has_worst ? worst_ball(book.model().mesh, result, result.worst) : std::nullopt;
  if (!ball) return;
  draw_ball_section(book, {margin_left + tables_width + 6, top, section_size, section_size + 8}, result,
                    *ball);
  flow.move_to(std::max(flow.y(), top + section_size + 8 + caption_height + 2));
}

}  // namespace gabarit::pdf
