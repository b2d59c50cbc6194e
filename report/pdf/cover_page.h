// The cover: what was checked by which rules, and how it ended.
#pragma once

#include "report/pdf/book.h"

namespace gabarit::pdf {

void add_cover_page(Book& book);

}  // namespace gabarit::pdf
