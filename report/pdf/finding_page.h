// A page for one finding: what it looks like and where it is on the part.
#pragma once

#include "report/pdf/book.h"
#include "report/pdf/colouring.h"
#include "report/pdf/model_view.h"

namespace gabarit::pdf {

// `views`: of the rule, as drawn on its page; they show the place.
void add_finding_page(Book& book, const RuleResult& result, const Finding& finding,
                      const Colouring& colouring, const std::vector<DrawnView>& views);

}  // namespace gabarit::pdf
