#include "rules/worst.h"

#include <algorithm>
#include <cmath>

namespace gabarit {

double excess(const Field& field, std::size_t entry, const Limit& limit) {
  const double value = field.value[entry];
  const double under = limit.low - (std::isnan(value) ? field.lower[entry] : value);
  const double over = (std::isnan(value) ? field.upper[entry] : value) - limit.high;
  switch (limit.kind) {
    case Limit::Kind::at_least: return under;
    case Limit::Kind::at_most: return over;
    case Limit::Kind::between: break;
  }
  return std::max(under, over);
}

static int gravity(FacetVerdict verdict) {
  switch (verdict) {
    case FacetVerdict::fail: return 3;
    case FacetVerdict::undecided: return 2;
    case FacetVerdict::pass: return 1;
    case FacetVerdict::not_examined: break;
  }
  return 0;
}

std::size_t worst_entry(const Field& field, std::span<const FacetVerdict> verdicts, const Limit& limit,
                        std::span<const std::size_t> entries) {
  std::size_t worst = entries.front();
  double worst_excess = excess(field, worst, limit);
  for (const std::size_t entry : entries.subspan(1)) {
    const int graver = gravity(verdicts[entry]) - gravity(verdicts[worst]);
    if (graver < 0) continue;
    const double e = excess(field, entry, limit);
    if (graver > 0 || e > worst_excess || (std::isnan(worst_excess) && !std::isnan(e))) {
      worst = entry;
      worst_excess = e;
    }
  }
  return worst;
}

Worst worst_at(const Field& field, std::size_t entry) {
  return {.value = field.value[entry],
          .lower = field.lower[entry],
          .upper = field.upper[entry],
          .at = field.at[entry],
          .contact = field.contact[entry],
          .facet = field.facets[entry]};
}

}  // namespace gabarit
