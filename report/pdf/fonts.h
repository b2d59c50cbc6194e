// The faces of a report: which font shows a code point, how wide it is, and what no font can show.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "report/pdf/document.h"
#include "report/pdf/font_files.h"

namespace gabarit::pdf {

enum class Face { regular, bold, mono };

// A piece of text in one font, in that font's encoding.
struct Run {
  HPDF_Font font = nullptr;
  std::string bytes;
  double width = 0;  // at a size of one
};

class Fonts {
 public:
  // Embeds the faces, only the glyphs used. Without DejaVu Sans the built-in Helvetica and Courier stand in
  // and what they lack is shown as `?`.
  Fonts(Document& document, const FontFiles& files);

  // What the fonts cannot show is replaced by □ and remembered.
  std::vector<Run> runs(Face face, std::string_view text);
  // At a size of one.
  double width(Face face, char32_t code);
  double width(Face face, std::string_view text);

  bool embedded() const { return embedded_; }
  const std::set<char32_t>& missing() const { return missing_; }
  // The fonts in use, by name.
  const std::vector<std::string>& names() const { return names_; }

 private:
  struct Glyph {
    HPDF_Font font = nullptr;
    char32_t shown = 0;  // the code point itself or what stands for it
    double width = 0;    // at a size of one
  };
  HPDF_Font load(const std::filesystem::path& file);
  void load_faces(const FontFiles& files);
  void load_built_in();
  HPDF_Font fallback_for(char32_t code);
  const Glyph& glyph(Face face, char32_t code);
  Glyph find(Face face, char32_t code);

  Document* document_;
  std::array<HPDF_Font, 3> faces_{};  // by Face
  std::vector<std::filesystem::path> fallback_files_;
  std::vector<HPDF_Font> fallbacks_;  // of the first files, as far as they were needed; null: unusable
  std::array<std::unordered_map<char32_t, Glyph>, 3> glyphs_;
  std::set<char32_t> missing_;
  std::vector<std::string> names_;
  bool embedded_ = true;
};

}  // namespace gabarit::pdf
