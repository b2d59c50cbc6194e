#include <algorithm>

#include "gpu/batches.h"
#include "gpu/buffer.h"
#include "gpu/dexel.h"
#include "gpu/dexel_intervals.h"
#include "gpu/parallel_for.h"

namespace gabarit {
namespace {

// A point or an edge, with the range of x that its disk or rectangle keeps within.
struct Feature {
  Rectangle middle;  // of size 0 for a point
  double low, high;

  GABARIT_HD Dexel across(double radius, double y) const {
    return middle.size > 0 ? across_rectangle(middle, radius, y) : across_disk(middle.from, radius, y);
  }
};

// Which features may cross the lines of a block. Those that lie in it come first: they cover the most.
struct Bins {
  static constexpr std::int64_t lines = 16;  // in a block

  std::vector<Feature> features;
  std::vector<std::uint32_t> first;    // by block, and the end
  std::vector<std::uint32_t> numbers;  // of features
};

class Binning {
 public:
  Binning(const DexelLines& lines, double radius) : lines_(lines), radius_(radius) {
    bins_.first.assign(static_cast<std::size_t>((lines.count + Bins::lines - 1) / Bins::lines) + 1, 0);
  }
  void add(const Rectangle& middle, Point2 from, Point2 to) {
    // A little more than the radius, against rounding.
    const double reach = radius_ * (1 + 1e-6);
    bins_.features.push_back({middle, std::min(from.x, to.x) - reach, std::max(from.x, to.x) + reach});
    spans_.push_back({std::min(from.y, to.y), std::max(from.y, to.y)});
  }
  Bins finish() && {
    for_each_block([&](std::size_t block, std::uint32_t) { ++bins_.first[block + 1]; });
    for (std::size_t i = 1; i < bins_.first.size(); ++i) bins_.first[i] += bins_.first[i - 1];
    bins_.numbers.resize(bins_.first.back());
    std::vector<std::uint32_t> next = bins_.first;
    for_each_block([&](std::size_t block, std::uint32_t number) { bins_.numbers[next[block]++] = number; });
    return std::move(bins_);
  }

 private:
  struct Span {
    double low, high;
  };
  struct Blocks {
    std::int64_t first, last;
  };
  // A line more on either side, against rounding.
  Blocks blocks_of(double low, double high) const {
    const auto block = [&](double y) {
      const double line = (y - lines_.first) / lines_.spacing;
      return static_cast<std::int64_t>(std::clamp(line, 0.0, static_cast<double>(lines_.count - 1))) /
             Bins::lines;
    };
    return {block(low - lines_.spacing), block(high + lines_.spacing)};
  }
  template <class Use>
  void for_each_block(Use&& use) const {
    const auto visit = [&](std::uint32_t number, std::int64_t first, std::int64_t last) {
      for (std::int64_t b = first; b <= last; ++b) use(static_cast<std::size_t>(b), number);
    };
    for (std::uint32_t i = 0; i < spans_.size(); ++i) {
      const Blocks own = blocks_of(spans_[i].low, spans_[i].high);
      visit(i, own.first, own.last);
    }
    for (std::uint32_t i = 0; i < spans_.size(); ++i) {
      const Blocks own = blocks_of(spans_[i].low, spans_[i].high);
      const Blocks all = blocks_of(spans_[i].low - radius_, spans_[i].high + radius_);
      visit(i, all.first, own.first - 1);
      visit(i, own.last + 1, all.last);
    }
  }

  DexelLines lines_;
  double radius_;
  Bins bins_;
  std::vector<Span> spans_;  // in y
};

Bins bin(std::span<const Point2> points, std::span<const PlanEdge> edges, const DexelLines& lines,
         double radius) {
  Binning binning(lines, radius);
  for (const Point2 p : points) binning.add({p, {}, 0}, p, p);
  for (const PlanEdge& e : edges) binning.add(Rectangle::of(e), e.from, e.to);
  return std::move(binning).finish();
}

// Blocks of lines one after the other, with the features that cross them.
struct FeatureLists {
  View<const Feature> features;
  View<const std::uint32_t> first, numbers;  // as of Bins
};

// Goes on with what is on the lines already.
struct UniteLine {
  FeatureLists lists;
  DexelLines lines;
  std::int64_t first_line;
  double radius;
  std::int64_t capacity;
  View<Dexel> dexels;
  View<std::int64_t> count;  // by line; negative when there is not enough room

  GABARIT_HD void operator()(std::int64_t line) const {
    if (count[line] < 0) return;
    DexelUnion all{dexels.data + line * capacity, capacity, count[line]};
    const double y = lines.y(first_line + line);
    const std::int64_t block = line / Bins::lines;
    for (std::uint32_t i = lists.first[block]; i < lists.first[block + 1] && !all.overflow; ++i) {
      const Feature& feature = lists.features[lists.numbers[i]];
      if (!all.covers(feature.low, feature.high)) all.add(feature.across(radius, y));
    }
    count[line] = all.overflow ? -1 : all.size;
  }
};

// Some blocks, of each some of its features.
struct Part {
  std::int64_t begin, end;  // blocks
  std::int64_t from, to;    // of the list of each
};

std::size_t index(std::int64_t i) { return static_cast<std::size_t>(i); }

Bins part_of(const Bins& bins, const Part& part) {
  Bins out;
  std::vector<std::uint32_t> place(bins.features.size(), 0);  // in the part, from 1 on
  out.first.push_back(0);
  for (std::int64_t block = part.begin; block < part.end; ++block) {
    const std::int64_t first = bins.first[index(block)], end = bins.first[index(block + 1)];
    for (std::int64_t i = first + part.from; i < std::min(first + part.to, end); ++i) {
      const std::uint32_t number = bins.numbers[index(i)];
      if (place[number] == 0) {
        out.features.push_back(bins.features[number]);
        place[number] = static_cast<std::uint32_t>(out.features.size());
      }
      out.numbers.push_back(place[number] - 1);
    }
    out.first.push_back(static_cast<std::uint32_t>(out.numbers.size()));
  }
  return out;
}

class Uniting {
 public:
  Uniting(const Device& device, const Bins& bins, const DexelLines& lines, double radius)
      : device_(device), bins_(bins), lines_(lines), radius_(radius) {}

  Dexels all() && {
    out_.first.push_back(0);
    in_batches(blocks(), 1, [&](std::int64_t begin, std::int64_t end) { unite(begin, end); });
    return std::move(out_);
  }

 private:
  std::int64_t blocks() const { return static_cast<std::int64_t>(bins_.first.size()) - 1; }

  // Few lines run in and out of a figure often: more room is made when one needs it.
  void unite(std::int64_t begin, std::int64_t end) {
    const std::int64_t first = begin * Bins::lines;
    const std::int64_t n = std::min(end * Bins::lines, lines_.count) - first;
    for (std::int64_t capacity = 16;; capacity *= 4) {
      auto dexels = Buffer<Dexel>::of_size(device_, n * capacity);
      Buffer<std::int64_t> counts(device_, std::vector<std::int64_t>(index(n), 0));
      unite_into({{}, lines_, first, radius_, capacity, dexels.view(), counts.view()}, begin, end);
      const std::vector<std::int64_t> count = counts.read();
      if (*std::min_element(count.begin(), count.end()) < 0) continue;
      return gather(dexels.read(), count, capacity);
    }
  }

  // The figure of a line is the same whatever comes to it first.
  void unite_into(UniteLine kernel, std::int64_t begin, std::int64_t end) {
    std::int64_t longest = 1;
    for (std::int64_t b = begin; b < end; ++b)
      longest = std::max<std::int64_t>(longest, bins_.first[index(b + 1)] - bins_.first[index(b)]);
    constexpr std::int64_t few = 256;
    in_batches(longest, few, [&](std::int64_t from, std::int64_t to) {
      const bool whole = begin == 0 && end == blocks() && from == 0 && to == longest;
      const Bins part = whole ? Bins{} : part_of(bins_, {begin, end, from, to});
      const Bins& bins = whole ? bins_ : part;
      const Buffer<Feature> features(device_, bins.features);
      const Buffer<std::uint32_t> first(device_, bins.first), numbers(device_, bins.numbers);
      kernel.lists = {features.view(), first.view(), numbers.view()};
      parallel_for(device_, kernel.count.size, kernel, 8);
    });
  }

  void gather(const std::vector<Dexel>& rooms, const std::vector<std::int64_t>& count,
              std::int64_t capacity) {
    for (std::size_t line = 0; line < count.size(); ++line) {
      const auto begin = rooms.begin() + static_cast<std::ptrdiff_t>(line) * capacity;
      out_.all.insert(out_.all.end(), begin, begin + count[line]);
      out_.first.push_back(out_.all.size());
    }
  }

  Device device_;
  const Bins& bins_;
  DexelLines lines_;
  double radius_;
  Dexels out_;
};

}  // namespace

Dexels offset_dexels(const Device& device, std::span<const Point2> points, std::span<const PlanEdge> edges,
                     const DexelLines& lines, double radius) {
  if (lines.count <= 0) return {{0}, {}};
  const Bins bins = bin(points, edges, lines, radius);
  return Uniting(device, bins, lines, radius).all();
}

}  // namespace gabarit
