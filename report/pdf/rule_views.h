// The model from all sides, coloured by what a rule found.
#pragma once

#include "report/pdf/book.h"
#include "report/pdf/colouring.h"
#include "report/pdf/model_view.h"

namespace gabarit::pdf {

// One page: eight fixed views, each with scale bar and triad, and the legend. The pictures may be shown
// again.
std::vector<DrawnView> add_views_page(Book& book, const RuleResult& result, const Colouring& colouring);

}  // namespace gabarit::pdf
