// How a rule was checked: where it looks, what it measures, how it decides, and what is known to be weak.
#pragma once

#include "report/pdf/book.h"

namespace gabarit::pdf {

// Begins a chapter.
void add_method_page(Book& book, const RuleResult& result);

// The decision rule of a limit, in words.
std::string decision_text(const Requirement& require);

}  // namespace gabarit::pdf
