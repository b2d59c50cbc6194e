#include "report/pdf/document.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include <fmt/format.h>

#include "report/pdf/unicode.h"

namespace gabarit::pdf {

// libharu is C: an exception must not run through it, so the first error is kept and thrown later.
void Document::remember(HPDF_STATUS error, HPDF_STATUS detail, void* fault) {
  auto* const first = static_cast<Fault*>(fault);
  if (first->error == 0) *first = {error, detail};
}

Document::Document(const std::string& title, const std::string& creator, const std::string& date)
    : document_(HPDF_New(&Document::remember, &fault_)) {
  if (document_ == nullptr) throw std::bad_alloc();
  HPDF_SetCompressionMode(document_, HPDF_COMP_ALL);
  HPDF_UseUTFEncodings(document_);
  HPDF_SetCurrentEncoder(document_, "UTF-8");
  utf8_ = HPDF_GetEncoder(document_, "UTF-8");
  HPDF_SetInfoAttr(document_, HPDF_INFO_TITLE, title.c_str());
  HPDF_SetInfoAttr(document_, HPDF_INFO_CREATOR, creator.c_str());
  if (!date.empty()) set_date(date);
}

Document::~Document() { HPDF_Free(document_); }

void Document::set_date(const std::string& date) {
  HPDF_Date d{};
  if (std::sscanf(date.c_str(), "%d-%d-%dT%d:%d:%dZ", &d.year, &d.month, &d.day, &d.hour, &d.minutes,
                  &d.seconds) != 6)
    return;
  d.ind = 'Z';
  HPDF_SetInfoDateAttr(document_, HPDF_INFO_CREATION_DATE, d);
}

HPDF_Page Document::add_page() {
  const HPDF_Page page = HPDF_AddPage(document_);
  check();
  HPDF_Page_SetWidth(page, static_cast<HPDF_REAL>(page_width * points_per_mm));
  HPDF_Page_SetHeight(page, static_cast<HPDF_REAL>(page_height * points_per_mm));
  pages_.push_back(page);
  return page;
}

// White and black stay what they are.
static std::uint8_t coarse(std::uint8_t level) {
  return static_cast<std::uint8_t>((level & 0xFC) | level >> 6);
}

HPDF_Image Document::add_picture(Picture picture) {
  for (Rgb& p : picture.pixels) p = {coarse(p.r), coarse(p.g), coarse(p.b)};
  static_assert(sizeof(Rgb) == 3);
  const HPDF_Image image = HPDF_LoadRawImageFromMem(
      document_, reinterpret_cast<const HPDF_BYTE*>(picture.pixels.data()),
      static_cast<HPDF_UINT>(picture.width), static_cast<HPDF_UINT>(picture.height), HPDF_CS_DEVICE_RGB, 8);
  check();
  return image;
}

void Document::add_bookmark(const std::string& title) {
  // Of the basic plane only, as libharu has it; and readers show no more than a line.
  std::u32string codes = code_points(title.substr(0, 400)).substr(0, 80);
  std::replace_if(
      codes.begin(), codes.end(), [](char32_t c) { return c > 0xFFFF; }, U'\uFFFD');
  const HPDF_Outline entry = HPDF_CreateOutline(document_, nullptr, utf8(codes).c_str(), utf8_);
  const HPDF_Destination destination = HPDF_Page_CreateDestination(pages_.back());
  HPDF_Destination_SetFit(destination);
  HPDF_Outline_SetDestination(entry, destination);
}

void Document::check() const {
  if (fault_.error == 0) return;
  throw PdfError(
      fmt::format("the PDF could not be made: libharu error {:#x}, detail {}", fault_.error, fault_.detail));
}

bool Document::forgive() {
  const bool failed = fault_.error != 0;
  fault_ = {};
  HPDF_ResetError(document_);
  return failed;
}

void Document::save(OutputFile& file) {
  check();
  HPDF_SaveToStream(document_);
  check();
  std::array<HPDF_BYTE, 65536> bytes{};
  for (;;) {
    auto count = static_cast<HPDF_UINT32>(bytes.size());
    const HPDF_STATUS status = HPDF_ReadFromStream(document_, bytes.data(), &count);
    file.write(bytes.data(), count);
    if (status != HPDF_OK || count == 0) break;
  }
  forgive();  // the end of the stream counts as an error
}

}  // namespace gabarit::pdf
