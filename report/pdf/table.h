// A table that breaks over pages between its rows and repeats its head.
#pragma once

#include <string>
#include <vector>

#include "report/pdf/flow.h"
#include "rules/verdict.h"

namespace gabarit::pdf {

struct Column {
  enum class Align { left, right, decimal };  // decimal: the points of the numbers stand below each other
  std::string title;
  double width = 0;  // mm, the gap to the next column included
  Align align = Align::left;
  TextStyle style = small_text;
};

struct Cell {
  std::string text;
  std::optional<Verdict> badge = {};  // drawn in place of text
};

using Row = std::vector<Cell>;

struct Table {
  std::vector<Column> columns;
  std::vector<Row> rows;
  std::size_t most_lines = 3;  // in a cell; longer text is cut off with "…"
};

// How high it would stand on one page, head included.
double height(Fonts& fonts, const Table& table);
void draw(Flow& flow, const Table& table);

}  // namespace gabarit::pdf
