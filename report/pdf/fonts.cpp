#include "report/pdf/fonts.h"

#include <algorithm>

#include <hpdf_font.h>
#include <hpdf_fontdef.h>

#include "report/pdf/truetype.h"
#include "report/pdf/unicode.h"
#include "report/pdf/unicode_map.h"

namespace gabarit::pdf {

static HPDF_FontDef definition(HPDF_Font font) { return static_cast<HPDF_FontAttr>(font->attr)->fontdef; }

// libharu's UTF-8 fonts reach the basic plane only.
static bool has_glyph(HPDF_Font font, char32_t code) {
  return code < 0x10000 && HPDF_TTFontDef_GetGlyphid(definition(font), static_cast<HPDF_UINT16>(code)) != 0;
}

static double glyph_width(HPDF_Font font, char32_t code) {
  return HPDF_Font_GetUnicodeWidth(font, static_cast<HPDF_UNICODE>(code)) / 1000.0;
}

// Null when the file is no font that libharu can embed.
HPDF_Font Fonts::load(const std::filesystem::path& file) {
  if (file.empty() || !is_embeddable(file)) return nullptr;
  const bool collection = file.extension() == ".ttc";
  const char* const name = collection
                               ? HPDF_LoadTTFontFromFile2(document_->handle(), file.c_str(), 0, HPDF_TRUE)
                               : HPDF_LoadTTFontFromFile(document_->handle(), file.c_str(), HPDF_TRUE);
  const HPDF_Font font = name != nullptr ? HPDF_GetFont(document_->handle(), name, "UTF-8") : nullptr;
  if (document_->forgive() || font == nullptr) return nullptr;
  repair_unicode_map(font);
  names_.push_back(file.filename().string());
  return font;
}

void Fonts::load_faces(const FontFiles& files) {
  faces_[0] = load(files.regular);
  if (faces_[0] == nullptr) return;
  faces_[1] = load(files.bold);
  faces_[2] = load(files.mono);
  for (HPDF_Font& face : faces_) {
    if (face == nullptr) face = faces_[0];
  }
}

void Fonts::load_built_in() {
  constexpr std::array built_in{"Helvetica", "Helvetica-Bold", "Courier"};
  embedded_ = false;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    faces_[i] = HPDF_GetFont(document_->handle(), built_in[i], "WinAnsiEncoding");
    names_.emplace_back(built_in[i]);
  }
  document_->check();
}

Fonts::Fonts(Document& document, const FontFiles& files)
    : document_(&document), fallback_files_(files.fallbacks) {
  load_faces(files);
  if (faces_[0] == nullptr) load_built_in();
}

// A font is in the file once it is loaded, so that is left until it is needed.
HPDF_Font Fonts::fallback_for(char32_t code) {
  for (std::size_t i = 0; i < fallback_files_.size(); ++i) {
    if (i == fallbacks_.size()) fallbacks_.push_back(load(fallback_files_[i]));
    if (fallbacks_[i] != nullptr && has_glyph(fallbacks_[i], code)) return fallbacks_[i];
  }
  return nullptr;
}

// What the encoding of the built-in fonts has for a code point; it is Latin-1 with a few more.
static char32_t western(char32_t code) {
  static const std::map<char32_t, char32_t> likeness{
      {U'–', '-'},  {U'—', '-'}, {U'−', '-'}, {U'“', '"'}, {U'”', '"'}, {U'‘', '\''},
      {U'’', '\''}, {U'≥', '>'}, {U'≤', '<'}, {U'→', '>'}, {U'▸', '>'}, {U'\u202F', ' '}};
  if ((code >= 0x20 && code < 0x7F) || (code >= 0xA0 && code <= 0xFF)) return code;
  const auto found = likeness.find(code);
  return found == likeness.end() ? U'?' : found->second;
}

Fonts::Glyph Fonts::find(Face face, char32_t code) {
  const HPDF_Font first = faces_[static_cast<std::size_t>(face)];
  if (!embedded_) {
    const char32_t shown = western(code);
    if (shown == U'?' && code != U'?') missing_.insert(code);
    return {first, shown, glyph_width(first, shown)};
  }
  if (has_glyph(first, code)) return {first, code, glyph_width(first, code)};
  if (has_glyph(faces_[0], code)) return {faces_[0], code, glyph_width(faces_[0], code)};
  if (const HPDF_Font font = fallback_for(code)) return {font, code, glyph_width(font, code)};
  missing_.insert(code);
  constexpr char32_t box = U'□';
  return {faces_[0], box, glyph_width(faces_[0], box)};
}

const Fonts::Glyph& Fonts::glyph(Face face, char32_t code) {
  auto& known = glyphs_[static_cast<std::size_t>(face)];
  const auto found = known.find(code);
  return found != known.end() ? found->second : known.emplace(code, find(face, code)).first->second;
}

double Fonts::width(Face face, char32_t code) { return is_invisible(code) ? 0 : glyph(face, code).width; }

double Fonts::width(Face face, std::string_view text) {
  double sum = 0;
  for (const char32_t code : code_points(text)) sum += width(face, code);
  return sum;
}

// Runs of right-to-left letters are turned round, so that they read in their own direction; letters are not
// joined.
static std::u32string in_visual_order(std::u32string codes) {
  for (auto from = codes.begin(); from != codes.end();) {
    from = std::find_if(from, codes.end(), is_right_to_left);
    const auto to = std::find_if_not(from, codes.end(), is_right_to_left);
    std::reverse(from, to);
    from = to;
  }
  return codes;
}

std::vector<Run> Fonts::runs(Face face, std::string_view text) {
  std::vector<Run> list;
  for (const char32_t code : in_visual_order(code_points(text))) {
    if (is_invisible(code)) continue;
    const Glyph& g = glyph(face, code);
    if (list.empty() || list.back().font != g.font) list.push_back({g.font, {}, 0});
    if (embedded_) {
      append_utf8(list.back().bytes, g.shown);
    } else {
      list.back().bytes.push_back(static_cast<char>(g.shown));
    }
    list.back().width += g.width;
  }
  return list;
}

}  // namespace gabarit::pdf
