#include "checks/dexel_contours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gabarit {
namespace {

constexpr std::size_t nobody = static_cast<std::size_t>(-1);

struct Corner {
  std::int64_t column, row;  // of the square
  std::size_t place;
};

class Squares {
 public:
  Squares(const DexelLines& rows, const DexelLines& columns) : rows_(rows), columns_(columns) {}

  void add_on_row(Point2 p) {
    const std::int64_t row = std::llround((p.y - rows_.first) / rows_.spacing);
    add(p, column(p.x), row - 1);
    corners_.push_back({column(p.x), row, places_.size() - 1});
  }
  void add_on_column(Point2 p) {
    const std::int64_t at = std::llround((p.x - columns_.first) / columns_.spacing);
    add(p, at - 1, row(p.y));
    corners_.push_back({at, row(p.y), places_.size() - 1});
  }

  std::vector<Contour> contours() {
    join_all();
    std::vector<Contour> all;
    // Those that end somewhere come first, from their ends.
    for (const bool ends : {true, false}) {
      for (std::size_t i = 0; i < places_.size(); ++i)
        if (!used_[i] && (!ends || joined_[i][1] == nobody)) all.push_back(from(i));
    }
    return all;
  }

 private:
  void add(Point2 p, std::int64_t at_column, std::int64_t at_row) {
    places_.push_back(p);
    corners_.push_back({at_column, at_row, places_.size() - 1});
  }
  std::int64_t column(double x) const {
    return static_cast<std::int64_t>(std::floor((x - columns_.first) / columns_.spacing));
  }
  std::int64_t row(double y) const {
    return static_cast<std::int64_t>(std::floor((y - rows_.first) / rows_.spacing));
  }

  void join_all() {
    joined_.assign(places_.size(), {nobody, nobody});
    used_.assign(places_.size(), false);
    std::sort(corners_.begin(), corners_.end(), [](const Corner& a, const Corner& b) {
      return a.row != b.row ? a.row < b.row : a.column != b.column ? a.column < b.column : a.place < b.place;
    });
    for (std::size_t begin = 0; begin < corners_.size();) {
      std::vector<std::size_t> around;
      std::size_t end = begin;
      for (; end < corners_.size() && corners_[end].row == corners_[begin].row &&
             corners_[end].column == corners_[begin].column;
           ++end)
        around.push_back(corners_[end].place);
      join_around(corners_[begin], around);
      begin = end;
    }
  }

  void join_around(const Corner& square, std::vector<std::size_t>& around) {
    const Point2 middle{columns_.y(square.column) + columns_.spacing / 2,
                        rows_.y(square.row) + rows_.spacing / 2};
    std::sort(around.begin(), around.end(), [&](std::size_t a, std::size_t b) {
      const double x = angle(places_[a] - middle), y = angle(places_[b] - middle);
      return x != y ? x < y : a < b;
    });
    const auto size_of = [&](std::size_t first) {
      double sum = 0;
      for (std::size_t i = first; i + 1 < around.size() + first; i += 2)
        sum += length(places_[around[i]] - places_[around[(i + 1) % around.size()]]);
      return sum;
    };
    const std::size_t first = around.size() > 2 && size_of(1) < size_of(0) ? 1 : 0;
    for (std::size_t i = first; i + 1 < around.size() + first; i += 2)
      join(around[i], around[(i + 1) % around.size()]);
  }
  static double angle(Point2 p) { return std::atan2(p.y, p.x); }

  void join(std::size_t a, std::size_t b) {
    const auto free = [&](std::size_t i) { return joined_[i][1] == nobody; };
    if (a == b || !free(a) || !free(b)) return;
    joined_[a][joined_[a][0] == nobody ? 0 : 1] = b;
    joined_[b][joined_[b][0] == nobody ? 0 : 1] = a;
  }

  Contour from(std::size_t place) {
    Contour contour;
    const std::size_t first = place;
    for (std::size_t next = place; next != nobody;) {
      place = next;
      used_[place] = true;
      contour.points.push_back(places_[place]);
      next = nobody;
      for (const std::size_t other : joined_[place])
        if (other != nobody && !used_[other]) next = other;
    }
    contour.closed = contour.points.size() > 2 && (joined_[place][0] == first || joined_[place][1] == first);
    if (contour.closed) contour.points.push_back(contour.points.front());
    return contour;
  }

  DexelLines rows_, columns_;
  std::vector<Point2> places_;
  std::vector<Corner> corners_;
  std::vector<std::array<std::size_t, 2>> joined_;
  std::vector<bool> used_;
};

}  // namespace

std::vector<Contour> dexel_contours(const std::vector<Point2>& on_rows, const std::vector<Point2>& on_columns,
                                    const DexelLines& rows, const DexelLines& columns) {
  Squares squares(rows, columns);
  for (const Point2 p : on_rows) squares.add_on_row(p);
  for (const Point2 p : on_columns) squares.add_on_column(p);
  return squares.contours();
}

}  // namespace gabarit
