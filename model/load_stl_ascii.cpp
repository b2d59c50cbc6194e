#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "model/load_stl.h"
#include "model/number_word.h"
#include "model/text_encoding.h"
#include "model/weld.h"

namespace gabarit {
namespace {

bool is(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

// Words of the file, lower-cased by comparison; comments (#, ; and //) end at the end of their line.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  std::string_view next() {
    skip_blank();
    const std::size_t begin = at_;
    while (at_ < text_.size() && !blank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  // What stands behind "solid" or "endsolid": up to the end of the line, to a comment that exporters write
  // there, or to the next facet of a file that is all one line.
  std::string_view name() {
    while (at_ < text_.size() && blank(text_[at_]) && !line_end(text_[at_])) ++at_;
    const std::size_t begin = at_;
    std::size_t end = at_;
    while (at_ < text_.size() && !line_end(text_[at_]) && text_[at_] != '#') {
      const std::size_t word = at_;
      while (at_ < text_.size() && !blank(text_[at_])) ++at_;
      if (begins_part(word)) {
        at_ = word;
        break;
      }
      end = at_;
      while (at_ < text_.size() && blank(text_[at_]) && !line_end(text_[at_])) ++at_;
    }
    return text_.substr(begin, end - begin);
  }

  // Counted only when somebody asks, which is when something is wrong. CR, LF and CRLF each end a line.
  int line() const {
    int lines = 1;
    for (std::size_t i = 0; i < std::min(at_, text_.size()); ++i) {
      if (text_[i] == '\n' || (text_[i] == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n'))) ++lines;
    }
    return lines;
  }

 private:
  static bool blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  static bool line_end(char c) { return c == '\n' || c == '\r'; }

  // "facet normal" and "endsolid" are no part of a name.
  bool begins_part(std::size_t word) const {
    Words ahead(text_.substr(word, 64));
    const std::string_view first = ahead.next();
    return is(first, "endsolid") || (is(first, "facet") && is(ahead.next(), "normal"));
  }

  void skip_blank() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      const bool slashes = c == '/' && at_ + 1 < text_.size() && text_[at_ + 1] == '/';
      if (c == '#' || c == ';' || slashes) {
        while (at_ < text_.size() && !line_end(text_[at_])) ++at_;
      } else if (blank(c)) {
        ++at_;
      } else {
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

class AsciiStl {
 public:
  AsciiStl(std::string_view text, const std::string& file, double scale, Model& model)
      : words_(text),
        file_(file),
        scale_(scale),
        model_(model),
        weld_(model.mesh.vertices, text.size() / 500) {}

  Diagnostics read() {
    for (std::string_view word = words_.next(); !word.empty() && errors_.empty(); word = words_.next()) {
      if (is(word, "solid")) {
        begin_solid();
      } else if (is(word, "endsolid")) {
        words_.name();
        in_solid_ = false;
      } else if (is(word, "facet")) {
        facet();
      } else {
        fail(word, "'solid', 'facet' or 'endsolid'");
      }
    }
    // Without it nobody can tell a whole file from one that was cut short between two facets.
    if (in_solid_) fail({}, "'endsolid'");
    tell_of_names();
    return errors_;
  }

 private:
  void fail(std::string_view found, const std::string& wanted) {
    if (!errors_.empty()) return;
    const std::string what =
        found.empty() ? "the file ends" : fmt::format("found '{}'", valid_utf8(found.substr(0, 40)));
    errors_.push_back({.file = file_,
                       .line = words_.line(),
                       .column = 1,
                       .message = fmt::format("{} where {} should stand{}", what, wanted,
                                              found.empty() ? ": it is cut short; export it again" : "")});
  }

  void begin_solid() {
    const std::string_view given = words_.name();
    const std::string name = valid_utf8(given);
    names_repaired_ += name != given;
    model_.bodies.push_back(name.empty() ? fmt::format("solid {}", model_.bodies.size() + 1) : name);
    in_solid_ = true;
  }

  void tell_of_names() {
    if (names_repaired_ == 0) return;
    model_.warnings.push_back(
        {.level = Diagnostic::Level::warning,
         .file = file_,
         .message = fmt::format("{} names of solids are not plain UTF-8; what cannot be read was replaced",
                                names_repaired_)});
  }

  void expect(std::string_view wanted) {
    if (!errors_.empty()) return;
    if (const std::string_view word = words_.next(); !is(word, wanted))
      fail(word, fmt::format("'{}'", wanted));
  }

  double number() {
    double value = 0;
    if (!errors_.empty()) return value;
    if (const std::string_view word = words_.next(); !read_number(word, value)) fail(word, "a number");
    return value;
  }

  void facet() {
    if (!in_solid_) begin_unnamed();
    expect("normal");
    for (int i = 0; i < 3; ++i) number();
    expect("outer");
    expect("loop");
    std::array<Vec3d, 3> corners{};
    for (Vec3d& corner : corners) {
      expect("vertex");
      corner.x = number(), corner.y = number(), corner.z = number();
      corner *= scale_;
    }
    expect("endloop");
    expect("endfacet");
    if (!errors_.empty()) return;
    std::array<VertexId, 3> numbers{};
    weld_.add(corners, numbers.data());
    model_.mesh.facets.push_back(numbers);
    model_.mesh.body.push_back(static_cast<std::uint32_t>(model_.bodies.size() - 1));
  }

  void begin_unnamed() {
    model_.bodies.push_back(fmt::format("solid {}", model_.bodies.size() + 1));
    in_solid_ = true;
  }

  Words words_;
  std::string file_;
  double scale_;
  Model& model_;
  VertexWeld weld_;
  Diagnostics errors_;
  bool in_solid_ = false;
  std::uint64_t names_repaired_ = 0;
};

}  // namespace

bool begins_as_ascii_stl(std::string_view text) {
  const std::string_view first = Words(text).next();
  return is(first, "solid") || is(first, "facet");
}

Diagnostics load_ascii_stl(std::string_view text, const std::string& name, double scale, Model& model) {
  model.format = "ASCII STL";
  return AsciiStl(text, name, scale, model).read();
}

}  // namespace gabarit
