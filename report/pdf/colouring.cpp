#include "report/pdf/colouring.h"

#include <algorithm>
#include <cmath>

#include "report/distribution.h"

namespace gabarit::pdf {

Rgb facet_colour(FacetVerdict verdict) {
  switch (verdict) {
    case FacetVerdict::pass: return palette::pass;
    case FacetVerdict::fail: return palette::fail;
    case FacetVerdict::undecided: return palette::undecided;
    case FacetVerdict::not_examined: break;
  }
  return palette::out_of_reach;
}

static bool shows_values(const TriangleMesh& mesh, const RuleResult& result) {
  const Measure* const measure = result.rule.require.measure;
  if (measure == nullptr) return false;
  if (measure->varies_within_facets)
    return std::any_of(result.field.value.begin(), result.field.value.end(),
                       [](double value) { return std::isfinite(value); });
  if (!result.region.depth.empty()) return false;
  double whole = 0, finite = 0;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) whole += facet_area(mesh, f);
  for (std::size_t i = 0; i < result.field.size(); ++i) {
    if (std::isfinite(result.field.value[i])) finite += facet_area(mesh, result.field.facets[i]);
  }
  return finite > whole / 2;
}

static ColourScale scale_of(const TriangleMesh& mesh, const RuleResult& result, double factor,
                            ColourMap map) {
  std::vector<double> values = result.field.value;
  for (double& value : values) value *= factor;
  const std::optional<Limit> limit = displayed(result.rule.require.limit, factor);
  const DisplayRange range = display_range(values, areas_of(result.field, mesh), limit);
  return {range.low, range.high, limit, map};
}

Colouring colouring(const TriangleMesh& mesh, const RuleResult& result, ColourMap map) {
  const double factor = display_factor(result.rule.require);
  Colouring c;
  c.facets.assign(mesh.facet_count(), palette::out_of_reach);
  c.by_value = shows_values(mesh, result);
  if (c.by_value) c.scale = scale_of(mesh, result, factor, map);
  for (std::size_t i = 0; i < std::min(result.facet_verdicts.size(), result.field.size()); ++i) {
    const FacetVerdict verdict = result.facet_verdicts[i];
    // What is undecided stands out, whatever its value.
    const bool value =
        c.by_value && verdict != FacetVerdict::undecided && verdict != FacetVerdict::not_examined;
    c.facets[result.field.facets[i]] =
        value ? c.scale.colour(result.field.value[i] * factor) : facet_colour(verdict);
  }
  return c;
}

std::vector<std::uint8_t> marks(const TriangleMesh& mesh, std::span<const RuleResult> results) {
  std::vector<std::uint8_t> marked(mesh.facet_count());
  for (const RuleResult& result : results) {
    for (std::size_t i = 0; i < std::min(result.facet_verdicts.size(), result.field.size()); ++i) {
      const FacetVerdict verdict = result.facet_verdicts[i];
      const std::uint8_t mark = verdict == FacetVerdict::fail        ? 2
                                : verdict == FacetVerdict::undecided ? 1
                                                                     : 0;
      marked[result.field.facets[i]] = std::max(marked[result.field.facets[i]], mark);
    }
  }
  return marked;
}

std::vector<Rgb> verdict_colours(const TriangleMesh& mesh, const Outcome& outcome) {
  std::vector<FacetVerdict> gravest(mesh.facet_count(), FacetVerdict::not_examined);
  constexpr auto weight = [](FacetVerdict v) {
    return v == FacetVerdict::fail ? 3 : v == FacetVerdict::undecided ? 2 : v == FacetVerdict::pass ? 1 : 0;
  };
  for (const RuleResult& result : outcome.results) {
    for (std::size_t i = 0; i < std::min(result.facet_verdicts.size(), result.field.size()); ++i) {
      FacetVerdict& there = gravest[result.field.facets[i]];
      if (weight(result.facet_verdicts[i]) > weight(there)) there = result.facet_verdicts[i];
    }
  }
  std::vector<Rgb> colours;
  colours.reserve(gravest.size());
  for (const FacetVerdict verdict : gravest) colours.push_back(facet_colour(verdict));
  return colours;
}

}  // namespace gabarit::pdf
