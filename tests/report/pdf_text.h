// What a reader of a PDF file sees, by way of poppler's tools.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/write_pdf.h"

namespace gabarit {

// Small pictures: tests look at words.
PdfOptions quick_pdf();

// Written to a temporary folder and read back.
std::string pdf_bytes(const Report& report, const PdfOptions& options = quick_pdf());
// The text of each page, with line breaks and runs of spaces as one space.
std::vector<std::string> pdf_pages(const Report& report, const PdfOptions& options = quick_pdf());
std::string pdf_text(const Report& report, const PdfOptions& options = quick_pdf());

struct Word {
  double left, top, right, bottom;  // points from the top left corner of the page
  std::string text;
};
std::vector<Word> pdf_words(const Report& report, const PdfOptions& options = quick_pdf());

}  // namespace gabarit
