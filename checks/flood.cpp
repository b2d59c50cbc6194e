#include "checks/flood.h"

#include <algorithm>

namespace gabarit {
namespace {

// Free cells in a row, end excluded.
struct Run {
  std::int64_t begin, end;
  std::size_t parent;
};

class Runs {
 public:
  // Adds the runs of a row and joins them with those of the row before that they touch.
  void add_row(const float* value, std::int64_t columns, double free) {
    const std::size_t above_end = runs_.size();
    std::size_t above = row_begin_;
    row_begin_ = above_end;
    for (std::int64_t x = 0; x < columns; ++x) {
      if (!(value[x] >= free)) continue;
      const std::int64_t begin = x;
      while (x < columns && value[x] >= free) ++x;
      runs_.push_back({begin, x, runs_.size()});
      while (above < above_end && runs_[above].end < begin) ++above;
      for (std::size_t i = above; i < above_end && runs_[i].begin <= x; ++i) join(i, runs_.size() - 1);
    }
    row_ends_.push_back(runs_.size());
  }
  // Sets the cells of the runs that hang together with the first one.
  void fill_first(std::int64_t columns, std::uint8_t* cells) {
    std::size_t i = 0;
    for (const std::size_t end : row_ends_) {
      for (; i < end; ++i) {
        if (root(i) == 0) std::fill(cells + runs_[i].begin, cells + runs_[i].end, 1);
      }
      cells += columns;
    }
  }

 private:
  std::size_t root(std::size_t i) {
    while (runs_[i].parent != i) i = runs_[i].parent = runs_[runs_[i].parent].parent;
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    runs_[std::max(a, b)].parent = std::min(a, b);
  }

  std::vector<Run> runs_;
  std::vector<std::size_t> row_ends_;
  std::size_t row_begin_ = 0;
};

}  // namespace

std::vector<std::uint8_t> flood(const CellGrid& grid, const std::vector<float>& value, double free) {
  std::vector<std::uint8_t> reached(value.size(), 0);
  Runs runs;
  for (std::int64_t y = 0; y < grid.rows; ++y)
    runs.add_row(value.data() + y * grid.columns, grid.columns, free);
  runs.fill_first(grid.columns, reached.data());
  return reached;
}

}  // namespace gabarit
