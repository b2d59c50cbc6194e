// How much area has which value: the bars of the report's histogram and the figures beside it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "checks/field.h"
#include "rules/rule.h"

namespace gabarit {

// The values that a scale shows: 0 or less at the low end, and at the high end enough for the limit and for
// 95 % of the area, ending at a round number. Values without bound (a flat facet's radius) do not count.
struct DisplayRange {
  double low = 0, high = 1;
};

struct HistogramBin {
  double from = 0, to = 0;  // a value on an edge belongs to the bin above, on an upper limit to the bin below
  double area = 0;          // mm²
  std::size_t facets = 0;
  bool critical = false;  // beyond the limit
};

// Every facet is in exactly one bin, below or above them, or without a value: the areas add up to total_area.
struct Histogram {
  std::vector<HistogramBin> bins;         // ascending, without gaps; each limit inside is an edge
  double area_below = 0, area_above = 0;  // mm² of values outside the bins; infinite ones are above
  double area_without = 0;                // mm² of facets without a value
  double total_area = 0;
  double minimum = 0, maximum = 0;  // NaN without values; the maximum may be infinite
  double mean = 0;                  // of the finite values, weighted by area; NaN without
  // By value alone. What fails is decided by the bounds, and may be less: some of it may be undecided.
  double critical_area = 0;
  std::size_t critical_facets = 0;

  double low() const { return bins.front().from; }
  double high() const { return bins.back().to; }
  double share(double area) const { return total_area > 0 ? area / total_area : 0; }
};

// `values` and `areas` have one entry a facet.
DisplayRange display_range(std::span<const double> values, std::span<const double> areas,
                           const std::optional<Limit>& limit);
// About `bins` of them over the range, of one round width (with `between`: of a width that divides the
// allowed range); the outermost may reach past it.
Histogram histogram(std::span<const double> values, std::span<const double> areas, const DisplayRange& range,
                    const std::optional<Limit>& limit, int bins = 40);

// The bins between given edges, ascending; equal ones count once.
Histogram histogram_between(const std::vector<double>& edges, std::span<const double> values,
                            std::span<const double> areas, const std::optional<Limit>& limit);

// mm² of each measured facet: the weights of a field.
std::vector<double> areas_of(const Field& field, const TriangleMesh& mesh);

}  // namespace gabarit
