// The whole result on one page, the number that decides first.
#pragma once

#include "report/pdf/book.h"

namespace gabarit::pdf {

void add_summary_page(Book& book);

}  // namespace gabarit::pdf
