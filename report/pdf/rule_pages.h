// The chapters of the rules: method, pictures, distribution and findings of each.
#pragma once

#include "report/pdf/book.h"

namespace gabarit::pdf {

void add_rule_pages(Book& book);

}  // namespace gabarit::pdf
