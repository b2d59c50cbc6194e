// Which measured facet breaks a limit the most.
#pragma once

#include <span>

#include "rules/outcome.h"

namespace gabarit {

// How far a field entry is on the wrong side of the limit, mm (or the measure's unit); the greater, the
// worse. An entry without a value counts by the bound that is nearer to breaking the limit.
double excess(const Field& field, std::size_t entry, const Limit& limit);

// The worst of some entries: proven fails before undecided ones before passes, then by excess, then the
// lowest entry. `entries` must not be empty.
std::size_t worst_entry(const Field& field, std::span<const FacetVerdict> verdicts, const Limit& limit,
                        std::span<const std::size_t> entries);

Worst worst_at(const Field& field, std::size_t entry);

}  // namespace gabarit
