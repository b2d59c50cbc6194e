// The last page: its end is said, what it is evidence of, and who signs.
#pragma once

#include "report/pdf/book.h"

namespace gabarit::pdf {

void add_end_page(Book& book);

}  // namespace gabarit::pdf
