// report.pdf: the evidence that a reviewer reads, page by page, and signs.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "gpu/device.h"
#include "report/output_file.h"
#include "report/palette.h"
#include "report/report.h"

namespace gabarit {

// How much is written out; what is left out is said on the page, with how much there is in all.
struct PdfLimits {
  std::size_t rules = 40;              // with pages of their own: those that need attention come first
  std::size_t findings_a_rule = 8;     // with a page of their own; rules that are notes have none
  std::size_t findings = 60;           // with a page of their own, over all rules
  std::size_t table_rows = 1000;       // of the annex's table of findings
  std::size_t rule_file_lines = 1200;  // of each rule file in the annex
};

struct PdfOptions {
  Device device = {};  // draws the pictures
  // Of the pictures, dots an inch; many pictures have fewer, so that together they keep to the megapixels
  // (and the file to some 4 MB), but never under 80.
  double resolution = 200, megapixels = 12;
  ColourMap palette = ColourMap::by_limit;  // of the pictures that show values
  PdfLimits limits = {};
  std::filesystem::path installed = {};  // what came with the program, fonts among it; may be empty
  // Where fonts are looked for; not given: see pdf::find_usual_fonts.
  std::optional<std::vector<std::filesystem::path>> font_folders = {};
  std::function<void(double fraction)> progress = {};  // may be empty
};

// A4. The same report gives the same bytes on any number of threads, given the same fonts. Throws
// pdf::PdfError when libharu refuses, filesystem_error when the file can't be written.
void write_pdf(const Report& report, const PdfOptions& options, OutputFile& file);

}  // namespace gabarit
