// What was checked and how it was set up: file, unit, bodies, defects, frame, sag.
#pragma once

#include "report/pdf/book.h"

namespace gabarit::pdf {

void add_item_page(Book& book);

}  // namespace gabarit::pdf
