#include "report/pdf/table.h"

#include <algorithm>

#include "report/pdf/badge.h"

namespace gabarit::pdf {

namespace {

constexpr double gap = 2.5, padding = 0.9;  // mm
constexpr TextStyle head_text{Face::bold, 7, soft, 3.75};

struct Layout {
  std::vector<double> behind_point;  // by column: mm right of the decimal points
};

std::size_t point_of(const std::string& text) { return std::min(text.find('.'), text.size()); }

Layout measure(Fonts& fonts, const Table& table) {
  Layout layout;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const TextStyle& style = table.columns[c].style;
    double widest = 0;
    for (const Row& row : table.rows) {
      const std::string tail = row[c].text.substr(point_of(row[c].text));
      if (table.columns[c].align == Column::Align::decimal && tail.size() < 20) {
        widest = std::max(widest, fonts.width(style.face, tail) * style.size / points_per_mm);
      }
    }
    layout.behind_point.push_back(widest);
  }
  return layout;
}

std::vector<std::string> lines_of(Fonts& fonts, const Cell& cell, const Column& column, std::size_t most) {
  return wrap(fonts, cell.text, column.style, column.width - gap, most);
}

double row_height(Fonts& fonts, const Table& table, const Row& row) {
  double highest = 0;
  for (std::size_t c = 0; c < row.size(); ++c) {
    const Column& column = table.columns[c];
    const auto lines = static_cast<double>(lines_of(fonts, row[c], column, table.most_lines).size());
    highest = std::max(highest, lines * column.style.leading);
  }
  return highest + 2 * padding;
}

double head_height(Fonts& fonts, const Table& table) {
  std::size_t most = 1;
  for (const Column& column : table.columns) {
    most = std::max(most, wrap(fonts, column.title, head_text, column.width - gap, 2).size());
  }
  return static_cast<double>(most) * head_text.leading + 2 * padding;
}

void draw_line(Flow& flow, const Column& column, const std::string& line, Place at, double behind_point) {
  Canvas& canvas = flow.canvas();
  const double right = at.x + column.width - gap;
  if (column.align == Column::Align::right) return canvas.text_right({right, at.y}, line, column.style);
  if (column.align == Column::Align::left) return canvas.text(at, line, column.style);
  const std::string whole = line.substr(0, point_of(line));
  const double left = right - behind_point - canvas.width(whole, column.style);
  canvas.text({std::max(at.x, left), at.y}, line, column.style);
}

void draw_row(Flow& flow, const Table& table, const Layout& layout, const Row& row) {
  double x = margin_left;
  for (std::size_t c = 0; c < row.size(); ++c) {
    const Column& column = table.columns[c];
    double y = flow.y() + padding + 0.75 * column.style.leading;
    if (row[c].badge) draw_small_badge(flow.canvas(), {x, y}, *row[c].badge);
    for (const std::string& line : lines_of(flow.fonts(), row[c], column, table.most_lines)) {
      draw_line(flow, column, line, {x, y}, layout.behind_point[c]);
      y += column.style.leading;
    }
    x += column.width;
  }
}

void draw_rule(Flow& flow, const Table& table, Rgb colour, double width) {
  double right = margin_left;
  for (const Column& column : table.columns) right += column.width;
  flow.canvas().line({margin_left, flow.y()}, {right, flow.y()}, colour, width);
}

void draw_head(Flow& flow, const Table& table) {
  double x = margin_left;
  for (const Column& column : table.columns) {
    double y = flow.y() + padding + 0.75 * head_text.leading;
    for (const std::string& line : wrap(flow.fonts(), column.title, head_text, column.width - gap, 2)) {
      if (column.align == Column::Align::left) {
        flow.canvas().text({x, y}, line, head_text);
      } else {
        flow.canvas().text_right({x + column.width - gap, y}, line, head_text);
      }
      y += head_text.leading;
    }
    x += column.width;
  }
  flow.skip(head_height(flow.fonts(), table));
  draw_rule(flow, table, soft, 0.3);
}

}  // namespace

double height(Fonts& fonts, const Table& table) {
  double sum = head_height(fonts, table);
  for (const Row& row : table.rows) sum += row_height(fonts, table, row);
  return sum;
}

void draw(Flow& flow, const Table& table) {
  const Layout layout = measure(flow.fonts(), table);
  flow.need(head_height(flow.fonts(), table) + 3 * grid_step);
  draw_head(flow, table);
  for (const Row& row : table.rows) {
    const double high = row_height(flow.fonts(), table, row);
    if (flow.room() < high) {
      flow.need(high);
      draw_head(flow, table);
    }
    draw_row(flow, table, layout, row);
    flow.skip(high);
    draw_rule(flow, table, hairline, 0.15);
  }
  flow.skip(grid_step);
}

}  // namespace gabarit::pdf
