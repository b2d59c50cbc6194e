#include "report/write_pdf.h"

#include <fmt/format.h>

#include "report/pdf/annex_pages.h"
#include "report/pdf/book.h"
#include "report/pdf/cover_page.h"
#include "report/pdf/end_page.h"
#include "report/pdf/item_page.h"
#include "report/pdf/rule_pages.h"
#include "report/pdf/summary_page.h"

namespace gabarit {

static pdf::FontFiles fonts_for(const PdfOptions& options) {
  return options.font_folders ? pdf::find_fonts(*options.font_folders)
                              : pdf::find_usual_fonts(options.installed);
}

void write_pdf(const Report& report, const PdfOptions& options, OutputFile& file) {
  pdf::Document document("Gabarit report " + report.id, "Gabarit " + report.version, report.date);
  pdf::Fonts fonts(document, fonts_for(options));
  pdf::Book book(report, options, document, fonts);
  pdf::add_cover_page(book);
  pdf::add_summary_page(book);
  pdf::add_item_page(book);
  pdf::add_rule_pages(book);
  pdf::add_annex_pages(book);
  pdf::add_end_page(book);
  pdf::number_pages(
      document, fonts,
      fmt::format("Report {}  ·  Gabarit {}  ·  {}", report.id, report.version, report.model->file));
  document.save(file);
}

}  // namespace gabarit
