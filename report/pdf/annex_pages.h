// The annex: every finding, the rule files, the settings, versions and fonts.
#pragma once

#include "report/pdf/book.h"

namespace gabarit::pdf {

void add_annex_pages(Book& book);

}  // namespace gabarit::pdf
