#include "report/histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "report/ticks.h"

namespace gabarit {

static bool is_beyond(const std::optional<Limit>& limit, double value) {
  if (!limit) return false;
  return (limit->kind != Limit::Kind::at_most && value < limit->low) ||
         (limit->kind != Limit::Kind::at_least && value > limit->high);
}

// Values past this are without bound to a reader, and differences of such numbers are not safe.
static bool is_shown(double value) { return std::abs(value) < 1e300; }

// The value that a share of the area does not exceed; 0 without finite values.
static double quantile(std::span<const double> values, std::span<const double> areas, double share) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_shown(values[i])) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  double total = 0;
  for (const std::size_t i : order) total += areas[i];
  double sum = 0;
  for (const std::size_t i : order) {
    sum += areas[i];
    if (sum >= share * total) return values[i];
  }
  return 0;
}

DisplayRange display_range(std::span<const double> values, std::span<const double> areas,
                           const std::optional<Limit>& limit) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double least = infinity;
  double most = -infinity;
  for (const double value : values) {
    if (!is_shown(value)) continue;
    least = std::min(least, value), most = std::max(most, value);
  }
  DisplayRange range{std::min(0.0, least), std::max(0.0, quantile(values, areas, 0.95))};
  if (limit && limit->kind != Limit::Kind::at_most) {
    range.low = std::min(range.low, limit->low), range.high = std::max(range.high, 1.5 * limit->low);
  }
  if (limit && limit->kind != Limit::Kind::at_least) {
    range.low = std::min(range.low, limit->high), range.high = std::max(range.high, 1.5 * limit->high);
  }
  // A short tail is worth showing whole.
  if (most <= 1.25 * range.high) range.high = std::max(range.high, most);
  if (!(range.high > range.low)) range.high = range.low + std::max(1.0, std::abs(range.low));
  const double step = ticks(range.low, range.high, 10).step;
  return {std::floor(range.low / step) * step, std::ceil(range.high / step) * step};
}

// Edges `step` apart that meet a limit inside the range, from the last at or under the low end on.
static std::vector<double> edges(DisplayRange range, const std::optional<Limit>& limit, int about) {
  if (!(range.high - range.low > 1e-290) || !(range.high - range.low < 1e300)) range = {};
  double anchor = range.low;
  double step = round_up((range.high - range.low) / std::clamp(about, 1, 1000));
  if (limit) anchor = limit->kind == Limit::Kind::at_most ? limit->high : limit->low;
  if (!(anchor > range.low && anchor < range.high)) anchor = range.low;
  double parts = 0;
  const bool between = limit && limit->kind == Limit::Kind::between && anchor == limit->low;
  if (between && limit->high > anchor && limit->high <= range.high) {
    parts = std::ceil((limit->high - anchor) / step);
    step = (limit->high - anchor) / parts;
  }
  const double first = std::floor((range.low - anchor) / step);
  const double last = std::max(std::ceil((range.high - anchor) / step), first + 1);
  std::vector<double> result;
  const int count = static_cast<int>(std::min(last - first, 4096.0));
  for (int i = 0; i <= count; ++i) {
    const double k = first + i;
    result.push_back(parts > 0 && k == parts ? limit->high : anchor + k * step);
  }
  return result;
}

static std::vector<HistogramBin> empty_bins(const std::vector<double>& edges,
                                            const std::optional<Limit>& limit) {
  std::vector<HistogramBin> bins;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if (!(edges[i] < edges[i + 1])) continue;
    bins.push_back({edges[i], edges[i + 1], 0, 0, is_beyond(limit, edges[i] / 2 + edges[i + 1] / 2)});
  }
  if (bins.empty()) bins.push_back({edges.front(), edges.front() + 1, 0, 0, false});
  return bins;
}

// Puts one facet where it belongs.
static void add(Histogram& h, double value, double area, const std::optional<Limit>& limit) {
  if (value < h.low()) {
    h.area_below += area;
    return;
  }
  if (value > h.high()) {
    h.area_above += area;
    return;
  }
  auto bin = std::upper_bound(h.bins.begin(), h.bins.end(), value,
                              [](double v, const HistogramBin& b) { return v < b.from; });
  --bin;
  const bool on_upper_limit = limit && limit->kind != Limit::Kind::at_least && value == limit->high;
  if (on_upper_limit && value == bin->from && bin != h.bins.begin()) --bin;
  bin->area += area;
  ++bin->facets;
}

Histogram histogram(std::span<const double> values, std::span<const double> areas, const DisplayRange& range,
                    const std::optional<Limit>& limit, int bins) {
  return histogram_between(edges(range, limit, bins), values, areas, limit);
}

Histogram histogram_between(const std::vector<double>& edges, std::span<const double> values,
                            std::span<const double> areas, const std::optional<Limit>& limit) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Histogram h;
  h.bins = empty_bins(edges, limit);
  h.minimum = infinity, h.maximum = -infinity;
  double moment = 0;
  double finite_area = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    h.total_area += areas[i];
    if (std::isnan(values[i])) {
      h.area_without += areas[i];
      continue;
    }
    add(h, values[i], areas[i], limit);
    h.minimum = std::min(h.minimum, values[i]), h.maximum = std::max(h.maximum, values[i]);
    if (is_shown(values[i])) moment += values[i] * areas[i], finite_area += areas[i];
    if (is_beyond(limit, values[i])) h.critical_area += areas[i], ++h.critical_facets;
  }
  h.mean = finite_area > 0 ? moment / finite_area : std::nan("");
  if (h.minimum > h.maximum) h.minimum = h.maximum = std::nan("");
  return h;
}

std::vector<double> areas_of(const Field& field, const TriangleMesh& mesh) {
  std::vector<double> areas;
  areas.reserve(field.size());
  for (const FacetId f : field.facets) areas.push_back(facet_area(mesh, f));
  return areas;
}

}  // namespace gabarit
