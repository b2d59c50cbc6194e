#include "checks/dexel_path.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "checks/dexel_contours.h"
#include "checks/disjoint_sets.h"
#include "gpu/dexel.h"
#include "gpu/segment_grid.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_lines = 100'000;

struct Gap {
  double from, to;           // along the line; infinite outside of the last dexels
  std::int64_t first, last;  // squares along the line that it touches
  std::size_t number;
};

// What the dexels leave of the lines in one direction.
class Gaps {
 public:
  // `across`: the lines of the other direction, `numbered`: gaps that have numbers already.
  Gaps(const Dexels& dexels, const DexelLines& lines, const DexelLines& across, std::size_t numbered)
      : lines_(lines), across_(across) {
    first_.push_back(0);
    for (std::int64_t line = 0; line < lines.count; ++line) {
      double from = -infinity;
      for (const Dexel& dexel : dexels.line(line)) {
        add(from, dexel.from, numbered);
        from = dexel.to;
      }
      add(from, infinity, numbered);
      first_.push_back(gaps_.size());
    }
  }
  std::int64_t lines() const { return lines_.count; }
  double position(std::int64_t line) const { return lines_.y(line); }
  const std::vector<Gap>& all() const { return gaps_; }
  std::span<const Gap> line(std::int64_t i) const {
    const auto n = static_cast<std::size_t>(i);
    return std::span(gaps_).subspan(first_[n], first_[n + 1] - first_[n]);
  }

  // Visits the gaps of a line that touch the squares from `first` to `last`; no line, no gaps.
  template <class Visit>
  void touching(std::int64_t line_number, std::int64_t first, std::int64_t last, Visit&& visit) const {
    if (line_number < 0 || line_number >= lines_.count) return;
    const auto some = line(line_number);
    auto gap = std::partition_point(some.begin(), some.end(), [&](const Gap& g) { return g.last < first; });
    for (; gap != some.end() && gap->first <= last; ++gap) visit(*gap);
  }

 private:
  // Square i lies between the lines i and i + 1 of the other direction. What ends on a line touches both
  // sides.
  std::int64_t square(double at, double slack) const {
    const double lines = (at - across_.first) / across_.spacing + slack;
    return static_cast<std::int64_t>(
        std::floor(std::clamp(lines, -1.0, static_cast<double>(across_.count - 1))));
  }
  void add(double from, double to, std::size_t numbered) {
    gaps_.push_back({from, to, square(from, -1e-9), square(to, 1e-9), numbered + gaps_.size()});
  }

  DexelLines lines_, across_;
  std::vector<Gap> gaps_;
  std::vector<std::size_t> first_;
};

void join_neighbours(const Gaps& gaps, DisjointSets& spaces) {
  for (std::int64_t i = 0; i + 1 < gaps.lines(); ++i) {
    for (const Gap& gap : gaps.line(i))
      gaps.touching(i + 1, gap.first, gap.last,
                    [&](const Gap& next) { spaces.join(gap.number, next.number); });
  }
}

// Gaps of different directions that touch the same square cross there, or one of them ends there. Of the
// lines that a gap crosses one is enough: neighbours are joined already.
void join_across(const Gaps& gaps, const Gaps& across, DisjointSets& spaces) {
  for (std::int64_t i = 0; i < gaps.lines(); ++i) {
    for (const Gap& gap : gaps.line(i)) {
      for (const std::int64_t line : {gap.first, gap.first + 1, gap.last, gap.last + 1})
        across.touching(line, i - 1, i, [&](const Gap& other) { spaces.join(gap.number, other.number); });
    }
  }
}

// As many lines as it takes to have one free of everything on either side.
DexelLines lines_over(double low, double high, double radius, double spacing) {
  const double first = low - radius - 1.5 * spacing;
  const double count = std::ceil((high + radius - first) / spacing) + 2;
  if (!(count <= most_lines)) {
    throw std::invalid_argument(fmt::format(
        "lines {:g} mm apart are too many for {:.0f} mm: choose a wider spacing", spacing, high - low));
  }
  return {first, spacing, static_cast<std::int64_t>(count)};
}

Dexels dexels_along_x(const OutlineFeatures& outline, double radius, const DexelLines& lines, bool swapped,
                      const Device& device) {
  const auto placed = [&](Point2 p) { return swapped ? Point2{p.y, p.x} : p; };
  std::vector<Point2> points;
  points.reserve(outline.points.size());
  for (const Point2 p : outline.points) points.push_back(placed(p));
  std::vector<PlanEdge> edges;
  edges.reserve(outline.edges.size());
  for (const auto& [a, b] : outline.edges) edges.push_back({points[a], points[b]});
  return offset_dexels(device, points, edges, lines, radius);
}

// Where gaps that hang together with the first one end; x and y are exchanged when `swapped`.
std::vector<Point2> ends_outside(const Gaps& gaps, DisjointSets& spaces, bool swapped) {
  std::vector<Point2> ends;
  for (std::int64_t i = 0; i < gaps.lines(); ++i) {
    for (const Gap& gap : gaps.line(i)) {
      if (spaces.root(gap.number) != 0) continue;
      for (const double end : {gap.from, gap.to}) {
        if (std::isinf(end)) continue;
        ends.push_back(swapped ? Point2{gaps.position(i), end} : Point2{end, gaps.position(i)});
      }
    }
  }
  return ends;
}

}  // namespace

DiskPath dexel_path(const OutlineFeatures& outline, double radius, double spacing, const Device& device) {
  assert(spacing < radius / 2);
  DiskPath path;
  path.radius = radius;
  if (outline.points.empty()) return path;
  Box2 box;
  for (const Point2 p : outline.points) box.add(p);
  const DexelLines rows = lines_over(box.low.y, box.high.y, radius, spacing);
  const DexelLines columns = lines_over(box.low.x, box.high.x, radius, spacing);
  const Gaps along_x(dexels_along_x(outline, radius, rows, false, device), rows, columns, 0);
  const Gaps along_y(dexels_along_x(outline, radius, columns, true, device), columns, rows,
                     along_x.all().size());
  DisjointSets spaces(along_x.all().size() + along_y.all().size());
  join_neighbours(along_x, spaces);
  join_neighbours(along_y, spaces);
  join_across(along_x, along_y, spaces);
  join_across(along_y, along_x, spaces);
  // The first line is free: its gap, number 0, is the outside.
  const std::vector<Point2> on_rows = ends_outside(along_x, spaces, false);
  const std::vector<Point2> on_columns = ends_outside(along_y, spaces, true);
  for (const auto* ends : {&on_rows, &on_columns})
    for (const Point2 p : *ends) path.pieces.push_back({.from = p, .to = p, .centre = {}, .foot = {}});
  path.contours = dexel_contours(on_rows, on_columns, rows, columns);
  return path;
}

}  // namespace gabarit
