#include "bench/paper_dexels.h"

#include <algorithm>
#include <numeric>

#include "gpu/dexel_intervals.h"
#include "gpu/parallel_for.h"

namespace gabarit::paper {
namespace {

constexpr std::int64_t room = 256;  // dexels a line

struct Feature {
  std::int64_t number;       // points first, then edges
  std::int64_t first, last;  // lines that it may cross
};

std::int64_t line_at(double y, const DexelLines& lines) {
  return static_cast<std::int64_t>(
      std::clamp((y - lines.first) / lines.spacing, 0.0, static_cast<double>(lines.count - 1)));
}

// By the first line that each may cross.
std::vector<std::vector<Feature>> by_first_line(std::span<const Point2> points,
                                                std::span<const PlanEdge> edges, const DexelLines& lines,
                                                double radius) {
  std::vector<std::vector<Feature>> waiting(static_cast<std::size_t>(lines.count));
  std::int64_t number = 0;
  const auto add = [&](double low, double high) {
    const Feature f{number++, line_at(low - radius, lines), line_at(high + radius, lines)};
    waiting[static_cast<std::size_t>(f.first)].push_back(f);
  };
  for (const Point2 p : points) add(p.y, p.y);
  for (const PlanEdge& e : edges) add(std::min(e.from.y, e.to.y), std::max(e.from.y, e.to.y));
  return waiting;
}

// Lines that features still wait at; used up ones are skipped for good.
class Waiting {
 public:
  explicit Waiting(std::vector<std::vector<Feature>> features)
      : features_(std::move(features)), next_(features_.size() + 1) {
    std::iota(next_.begin(), next_.end(), std::size_t{0});
  }
  // Features that have no line in common, from the lowest line up; none when all are used.
  std::vector<Feature> round() {
    std::vector<Feature> chosen;
    for (std::size_t line = skip(0); line < features_.size();) {
      chosen.push_back(features_[line].back());
      features_[line].pop_back();
      line = skip(static_cast<std::size_t>(chosen.back().last) + 1);
    }
    return chosen;
  }

 private:
  std::size_t skip(std::size_t line) {
    while (line < features_.size() && (next_[line] != line || features_[line].empty())) {
      if (next_[line] == line) next_[line] = line + 1;
      next_[line] = next_[next_[line]];
      line = next_[line];
    }
    return line;
  }

  std::vector<std::vector<Feature>> features_;
  std::vector<std::size_t> next_;
};

struct UniteRound {
  std::span<const Point2> points;
  const std::vector<Rectangle>& rectangles;
  const std::vector<Feature>& round;
  const std::vector<std::int64_t>& begin;  // of each feature's lines among all of the round
  const DexelLines& lines;
  double radius;
  Dexel* dexels;
  std::int64_t* count;

  void operator()(std::int64_t i) const {
    const auto after = std::upper_bound(begin.begin(), begin.end(), i);
    const Feature& f = round[static_cast<std::size_t>(after - begin.begin()) - 1];
    const std::int64_t line = f.first + i - *std::prev(after);
    const double y = lines.y(line);
    const auto n = static_cast<std::size_t>(f.number);
    DexelUnion all{dexels + line * room, room, count[line]};
    all.add(n < points.size() ? across_disk(points[n], radius, y)
                              : across_rectangle(rectangles[n - points.size()], radius, y));
    count[line] = all.size;
  }
};

}  // namespace

Dexels offset_dexels(const Device& device, std::span<const Point2> points, std::span<const PlanEdge> edges,
                     const DexelLines& lines, double radius, std::int64_t& rounds) {
  Waiting waiting(by_first_line(points, edges, lines, radius));
  std::vector<Dexel> dexels(static_cast<std::size_t>(lines.count * room));
  std::vector<std::int64_t> count(static_cast<std::size_t>(lines.count), 0);
  std::vector<Rectangle> rectangles;
  for (const PlanEdge& e : edges) rectangles.push_back(Rectangle::of(e));
  std::vector<std::int64_t> begin;
  rounds = 0;
  for (auto round = waiting.round(); !round.empty(); round = waiting.round()) {
    begin.assign(1, 0);
    for (const Feature& f : round) begin.push_back(begin.back() + f.last - f.first + 1);
    const std::int64_t work = begin.back();
    begin.pop_back();
    parallel_for_cpu(device, work,
                     UniteRound{points, rectangles, round, begin, lines, radius, dexels.data(), count.data()},
                     256);
    ++rounds;
  }
  Dexels out;
  out.first.push_back(0);
  for (std::size_t line = 0; line < count.size(); ++line) {
    const auto from = dexels.begin() + static_cast<std::ptrdiff_t>(line) * room;
    out.all.insert(out.all.end(), from, from + count[line]);
    out.first.push_back(out.all.size());
  }
  return out;
}

}  // namespace gabarit::paper
