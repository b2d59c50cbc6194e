// A PDF document under construction, over libharu.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <hpdf.h>

#include "report/output_file.h"
#include "report/picture.h"

namespace gabarit::pdf {

// What libharu could not do, with its error numbers.
struct PdfError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A4 portrait in millimetres; places on a page are counted from its top left corner.
constexpr double page_width = 210, page_height = 297;
constexpr double points_per_mm = 72 / 25.4;

class Document {
 public:
  // Without a creation date when `date` (ISO 8601, UTC) is empty.
  Document(const std::string& title, const std::string& creator, const std::string& date);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;
  ~Document();

  HPDF_Doc handle() const { return document_; }
  HPDF_Page add_page();
  const std::vector<HPDF_Page>& pages() const { return pages_; }
  // May be shown any number of times. Colours are rounded to 64 levels a channel, which takes 40 % off the
  // file.
  HPDF_Image add_picture(Picture picture);
  // An entry of the outline that readers show beside the pages, leading to the newest page.
  void add_bookmark(const std::string& title);

  // Throws PdfError when a call of libharu since the last check went wrong.
  void check() const;
  // Forgets an error that was expected, such as a font that could not be read; whether there was one.
  bool forgive();

  // Deterministic: no clock, no random id.
  void save(OutputFile& file);

 private:
  struct Fault {
    HPDF_STATUS error = 0, detail = 0;
  };
  static void remember(HPDF_STATUS error, HPDF_STATUS detail, void* fault);
  void set_date(const std::string& date);

  Fault fault_;
  HPDF_Doc document_ = nullptr;
  HPDF_Encoder utf8_ = nullptr;
  std::vector<HPDF_Page> pages_;
};

}  // namespace gabarit::pdf
