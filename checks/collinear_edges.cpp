#include "checks/collinear_edges.h"

#include <algorithm>
#include <tuple>

namespace gabarit {
namespace {

// An edge along an axis, from its lower end to its upper one.
struct Stretch {
  bool along_x;
  double line;
  std::int8_t area;
  double from, to;
  std::uint32_t low, high;  // points

  auto order() const { return std::tuple(along_x, line, area, from, to, low, high); }
  bool goes_on(const Stretch& next) const {
    return along_x == next.along_x && line == next.line && area == next.area && next.from <= to;
  }
};

Stretch stretch_of(const OutlineFeatures& outline, std::size_t edge, bool along_x) {
  const auto [first, second] = outline.edges[edge];
  const Point2 a = outline.points[first];
  const Point2 b = outline.points[second];
  const double from = along_x ? a.x : a.y;
  const double to = along_x ? b.x : b.y;
  const double line = along_x ? a.y : a.x;
  const std::int8_t area = outline.area[edge];
  if (from < to) return {along_x, line, area, from, to, first, second};
  return {along_x, line, static_cast<std::int8_t>(-area), to, from, second, first};
}

class Builder {
 public:
  explicit Builder(const OutlineFeatures& outline)
      : in_(outline), number_(outline.points.size(), 0), of_edge_(outline.points.size(), 0) {
    for (const auto& [a, b] : outline.edges) of_edge_[a] = of_edge_[b] = 1;
    for (std::uint32_t p = 0; p < outline.points.size(); ++p) {
      if (of_edge_[p] == 0) keep(p);
    }
  }
  void add(std::uint32_t a, std::uint32_t b, std::int8_t area) {
    const std::uint32_t from = keep(a);
    const std::uint32_t to = keep(b);
    out_.edges.emplace_back(from, to);
    out_.area.push_back(area);
  }
  OutlineFeatures finish() && { return std::move(out_); }

 private:
  std::uint32_t keep(std::uint32_t point) {
    if (number_[point] == 0) {
      out_.points.push_back(in_.points[point]);
      number_[point] = static_cast<std::uint32_t>(out_.points.size());
    }
    return number_[point] - 1;
  }

  const OutlineFeatures& in_;
  OutlineFeatures out_;
  std::vector<std::uint32_t> number_;  // in `out_`, plus 1
  std::vector<std::uint8_t> of_edge_;
};

}  // namespace

OutlineFeatures join_collinear(const OutlineFeatures& outline) {
  Builder builder(outline);
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < outline.edges.size(); ++i) {
    const auto [a, b] = outline.edges[i];
    const bool along_x = outline.points[a].y == outline.points[b].y;
    if (along_x || outline.points[a].x == outline.points[b].x)
      stretches.push_back(stretch_of(outline, i, along_x));
    else
      builder.add(a, b, outline.area[i]);
  }
  std::sort(stretches.begin(), stretches.end(),
            [](const Stretch& a, const Stretch& b) { return a.order() < b.order(); });
  for (std::size_t i = 0; i < stretches.size();) {
    Stretch all = stretches[i];
    for (++i; i < stretches.size() && all.goes_on(stretches[i]); ++i) {
      if (stretches[i].to <= all.to) continue;
      all.to = stretches[i].to;
      all.high = stretches[i].high;
    }
    builder.add(all.low, all.high, all.area);
  }
  return std::move(builder).finish();
}

}  // namespace gabarit
