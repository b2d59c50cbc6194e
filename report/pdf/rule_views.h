// The model from all sides, coloured by what a rule found.
#pragma once

#include "report/pdf/book.h"
#include "report/pdf/colouring.h"

namespace gabarit::pdf {

// One page: eight fixed views, each with scale bar and triad, and the legend.
void add_views_page(Book& book, const RuleResult& result, const Colouring& colouring);

}  // namespace gabarit::pdf
