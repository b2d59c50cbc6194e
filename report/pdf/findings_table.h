// Tables of findings, worst first.
#pragma once

#include "report/pdf/book.h"

namespace gabarit::pdf {

// At most `most` rows, then how many there are in all.
void add_findings_table(Book& book, const RuleResult& result, std::size_t most);

}  // namespace gabarit::pdf
