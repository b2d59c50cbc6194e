// A page for one finding: what it looks like and where it is on the part.
#pragma once

#include "report/pdf/book.h"
#include "report/pdf/colouring.h"

namespace gabarit::pdf {

void add_finding_page(Book& book, const RuleResult& result, const Finding& finding,
                      const Colouring& colouring);

}  // namespace gabarit::pdf
