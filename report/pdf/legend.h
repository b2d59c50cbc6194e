// What the colours of a rule's pictures mean.
#pragma once

#include "report/pdf/book.h"
#include "report/pdf/colouring.h"

namespace gabarit::pdf {

// Across the content's width from the flow's place on; verdicts with their counts or a scale with the limit.
void draw_legend(Book& book, const RuleResult& result, const Colouring& colouring);

}  // namespace gabarit::pdf
