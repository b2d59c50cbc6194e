#include "report/distribution.h"

#include <algorithm>
#include <cmath>

#include "report/display_unit.h"

namespace gabarit {

double display_factor(const Requirement& require) {
  return require.measure != nullptr ? display_unit(require.measure->dimension).factor : 1;
}

Limit displayed(const Limit& limit, double factor) {
  return {limit.kind, limit.low * factor, limit.high * factor};
}

namespace {

struct Shown {
  std::vector<double> values, areas;
  Limit limit;
};

// None when no value is finite.
std::optional<Shown> shown(const RuleResult& result, const TriangleMesh& mesh) {
  const double factor = display_factor(result.rule.require);
  std::vector<double> values = result.field.value;
  for (double& value : values) value *= factor;
  if (std::none_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    return std::nullopt;
  return Shown{std::move(values), areas_of(result.field, mesh), displayed(result.rule.require.limit, factor)};
}

std::vector<double> edges(const Limit& limit) {
  std::vector<double> edges{0};
  const auto add = [&](double of, std::initializer_list<double> multiples) {
    for (const double multiple : multiples) edges.push_back(of * multiple);
  };
  switch (limit.kind) {
    case Limit::Kind::at_least: add(limit.low, {0.25, 0.5, 0.75, 1, 1.5, 2, 3, 5}); break;
    case Limit::Kind::at_most: add(limit.high, {0.25, 0.5, 0.75, 1, 1.25, 1.5, 2, 3}); break;
    case Limit::Kind::between:
      add(limit.low, {0.5, 1});
      edges.push_back(limit.low / 2 + limit.high / 2);
      add(limit.high, {1, 1.25, 1.5, 2});
      break;
  }
  return edges;
}

}  // namespace

std::optional<Histogram> distribution(const RuleResult& result, const TriangleMesh& mesh) {
  const std::optional<Shown> s = shown(result, mesh);
  if (!s) return std::nullopt;
  return histogram(s->values, s->areas, display_range(s->values, s->areas, s->limit), s->limit);
}

std::optional<Histogram> coarse_distribution(const RuleResult& result, const TriangleMesh& mesh) {
  const std::optional<Shown> s = shown(result, mesh);
  if (!s) return std::nullopt;
  return histogram_between(edges(s->limit), s->values, s->areas, s->limit);
}

std::vector<ValueRange> value_ranges(const Histogram& coarse, const Limit& limit) {
  std::vector<ValueRange> ranges;
  const auto add = [&](std::optional<double> from, std::optional<double> to, double area, bool critical) {
    ranges.push_back({from, to, area, coarse.share(area), critical});
  };
  if (coarse.area_below > 0)
    add(std::nullopt, coarse.low(), coarse.area_below, limit.kind != Limit::Kind::at_most);
  for (const HistogramBin& bin : coarse.bins) add(bin.from, bin.to, bin.area, bin.critical);
  if (coarse.area_above > 0)
    add(coarse.high(), std::nullopt, coarse.area_above, limit.kind != Limit::Kind::at_least);
  return ranges;
}

}  // namespace gabarit
