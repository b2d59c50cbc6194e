// The figures of a distribution: extremes, mean and critical area, and how much area lies in which range.
#pragma once

#include "report/pdf/book.h"

namespace gabarit::pdf {

// Two small tables, beside them the section through the worst ball where there is one; nothing when no facet
// has a finite value.
void add_ranges(Book& book, const RuleResult& result);

}  // namespace gabarit::pdf
