// How much of the examined area has which value.
#pragma once

#include "report/pdf/book.h"

namespace gabarit::pdf {

// With the limit marked; nothing when no facet has a finite value.
void add_histogram(Book& book, const RuleResult& result);

}  // namespace gabarit::pdf
