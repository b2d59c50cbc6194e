#include <algorithm>

#include "gpu/buffer.h"
#include "gpu/dexel.h"
#include "gpu/dexel_intervals.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

// Which features may cross the lines of a block, so that a line need not ask all of them.
struct Bins {
  static constexpr std::int64_t lines = 16;  // in a block

  std::vector<std::uint32_t> first;     // by block, and the end
  std::vector<std::uint32_t> features;  // points first, then edges
};

struct Blocks {
  std::int64_t first, last;
};

Blocks blocks_of(double low, double high, const DexelLines& lines) {
  const auto block = [&](double y) {
    const double line =
        std::clamp((y - lines.first) / lines.spacing, 0.0, static_cast<double>(lines.count - 1));
    return static_cast<std::int64_t>(line) / Bins::lines;
  };
  // A line more on either side, against rounding.
  return {block(low - lines.spacing), block(high + lines.spacing)};
}

Bins bin(std::span<const Point2> points, std::span<const PlanEdge> edges, const DexelLines& lines,
         double radius) {
  const auto for_each_block = [&](auto&& use) {
    std::uint32_t feature = 0;
    const auto enter = [&](double low, double high) {
      const Blocks blocks = blocks_of(low - radius, high + radius, lines);
      for (std::int64_t b = blocks.first; b <= blocks.last; ++b) use(static_cast<std::size_t>(b), feature);
      ++feature;
    };
    for (const Point2 p : points) enter(p.y, p.y);
    for (const PlanEdge& e : edges) enter(std::min(e.from.y, e.to.y), std::max(e.from.y, e.to.y));
  };
  Bins bins;
  bins.first.assign(static_cast<std::size_t>((lines.count + Bins::lines - 1) / Bins::lines) + 1, 0);
  for_each_block([&](std::size_t block, std::uint32_t) { ++bins.first[block + 1]; });
  for (std::size_t i = 1; i < bins.first.size(); ++i) bins.first[i] += bins.first[i - 1];
  bins.features.resize(bins.first.back());
  std::vector<std::uint32_t> next = bins.first;
  for_each_block([&](std::size_t block, std::uint32_t feature) { bins.features[next[block]++] = feature; });
  return bins;
}

struct UniteLine {
  View<const Point2> points;
  View<const PlanEdge> edges;
  View<const std::uint32_t> first, features;
  DexelLines lines;
  double radius;
  std::int64_t capacity;
  View<Dexel> dexels;
  View<std::int64_t> count;  // by line; negative when there is not enough room

  GABARIT_HD void operator()(std::int64_t line) const {
    DexelUnion all{dexels.data + line * capacity, capacity};
    const double y = lines.y(line);
    const std::int64_t block = line / Bins::lines;
    for (std::uint32_t i = first[block]; i < first[block + 1] && !all.overflow; ++i) {
      const std::int64_t feature = features[i];
      all.add(feature < points.size ? across_disk(points[feature], radius, y)
                                    : across_rectangle(edges[feature - points.size], radius, y));
    }
    count[line] = all.overflow ? -1 : all.size;
  }
};

Dexels gathered(const std::vector<Dexel>& rooms, const std::vector<std::int64_t>& count,
                std::int64_t capacity) {
  Dexels out;
  out.first.push_back(0);
  for (std::size_t line = 0; line < count.size(); ++line) {
    const auto begin = rooms.begin() + static_cast<std::ptrdiff_t>(line) * capacity;
    out.all.insert(out.all.end(), begin, begin + count[line]);
    out.first.push_back(out.all.size());
  }
  return out;
}

}  // namespace

Dexels offset_dexels(const Device& device, std::span<const Point2> points, std::span<const PlanEdge> edges,
                     const DexelLines& lines, double radius) {
  if (lines.count <= 0) return {{0}, {}};
  const Bins bins = bin(points, edges, lines, radius);
  const Buffer<Point2> centres(device, points);
  const Buffer<PlanEdge> middles(device, edges);
  const Buffer<std::uint32_t> first(device, bins.first), features(device, bins.features);
  std::vector<std::int64_t> count(static_cast<std::size_t>(lines.count));
  // Few lines run in and out of a figure often: more room is made when one needs it.
  for (std::int64_t capacity = 16;; capacity *= 4) {
    std::vector<Dexel> rooms(count.size() * static_cast<std::size_t>(capacity));
    Buffer<Dexel> dexels(device, rooms);
    Buffer<std::int64_t> counts(device, count);
    parallel_for(device, lines.count,
                 UniteLine{centres.view(), middles.view(), first.view(), features.view(), lines, radius,
                           capacity, dexels.view(), counts.view()},
                 8);
    counts.read(count);
    if (*std::min_element(count.begin(), count.end()) < 0) continue;
    dexels.read(rooms);
    return gathered(rooms, count, capacity);
  }
}

}  // namespace gabarit
