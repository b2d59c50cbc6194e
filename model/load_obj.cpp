#include "model/load_obj.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "model/face_list.h"
#include "model/number_word.h"
#include "model/text_encoding.h"
#include "model/text_lines.h"

namespace gabarit {
namespace {

// What a mesh without its looks does not need; curves and points have no surface.
constexpr std::array ignored_words{
    "vn",     "vt",     "vp",    "l",     "p",        "s",          "mg",       "usemtl", "mtllib",
    "usemap", "maplib", "lod",   "bevel", "c_interp", "d_interp",   "deg",      "bmat",   "step",
    "cstype", "curv",   "curv2", "parm",  "trim",     "hole",       "scrv",     "sp",     "end",
    "con",    "call",   "csh",   "ctech", "stech",    "shadow_obj", "trace_obj"};

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& file, Model& model)
      : lines_(text), file_(file), model_(model), cut_line_(!text.ends_with('\n') && !text.ends_with('\r')) {}

  Diagnostics read() {
    std::string_view line;
    while (errors_.empty() && next_line(line)) read_line(line);
    if (errors_.empty() && highest_ > faces_.points.size()) {
      errors_.push_back({.file = file_,
                         .line = highest_line_,
                         .column = 1,
                         .message = fmt::format("a face refers to point {}, the file has {}", highest_,
                                                faces_.points.size())});
    }
    if (errors_.empty() && cut_line_) {
      model_.warnings.push_back({.level = Diagnostic::Level::warning,
                                 .file = file_,
                                 .line = lines_.number(),
                                 .column = 1,
                                 .message =
                                     "the last line has no end: the file may be cut short, which OBJ does "
                                     "not tell; check that it is whole"});
    }
    warn_of_lines("free-form surfaces (surf) cannot be read and were left out; export the file as a mesh",
                  surfaces_);
    warn_of_lines("lines begin with a word that OBJ does not know and were left out", unknown_);
    return errors_;
  }

  FaceList& faces() { return faces_; }

 private:
  struct Skipped {
    std::uint64_t count = 0;
    int first_line = 0;
  };

  // A backslash at the end of a line continues it on the next one.
  bool next_line(std::string_view& line) {
    if (!lines_.next(line)) return false;
    if (!line.ends_with('\\')) return true;
    joined_.clear();
    do {
      joined_ += line.substr(0, line.size() - line.ends_with('\\'));
      joined_ += ' ';
    } while (line.ends_with('\\') && lines_.next(line));
    line = joined_;
    return true;
  }

  void read_line(std::string_view line) {
    line = without_comment(line);
    const std::string_view key = next_word(line);
    if (key.empty()) return;
    if (key == "v") return point(line);
    if (key == "f" || key == "fo") return face(line);
    if (key == "o" || key == "g") {
      body_name_ = valid_utf8(trimmed(line));
      body_known_ = false;
    } else if (key == "surf") {
      skip(surfaces_);
    } else if (std::find(ignored_words.begin(), ignored_words.end(), key) == ignored_words.end()) {
      skip(unknown_);
    }
  }

  void skip(Skipped& skipped) const {
    if (skipped.count++ == 0) skipped.first_line = lines_.number();
  }

  void point(std::string_view line) {
    Vec3d p;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = next_word(line);
      if (!read_number(word, p[axis])) return fail(word, "a coordinate");
    }
    faces_.points.push_back(p);
  }

  void face(std::string_view line) {
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      std::int64_t number = 0;
      if (!read_integer(word.substr(0, word.find('/')), number) || number == 0)
        return fail(word, "the number of a point");
      // Negative numbers count back from the last point so far; positive ones may come before their point.
      const auto points = static_cast<std::int64_t>(faces_.points.size());
      const std::int64_t at = number < 0 ? points + number : number - 1;
      if (at < 0 || at >= static_cast<std::int64_t>(most_points)) return fail(word, "the number of a point");
      if (at >= points && at + 1 > static_cast<std::int64_t>(highest_)) {
        highest_ = static_cast<std::uint64_t>(at) + 1;
        highest_line_ = lines_.number();
      }
      faces_.corners.push_back(static_cast<std::uint32_t>(at));
    }
    faces_.end_face();
    faces_.body.push_back(body());
  }

  // Numbered when it gets its first face: names alone make no body.
  std::uint32_t body() {
    if (body_known_) return body_;
    const auto [place, fresh] = bodies_.try_emplace(body_name_.empty() ? "default" : body_name_,
                                                    static_cast<std::uint32_t>(faces_.body_names.size()));
    if (fresh) faces_.body_names.push_back(place->first);
    body_known_ = true;
    return body_ = place->second;
  }

  void fail(std::string_view found, const std::string& wanted) {
    const std::string what =
        found.empty() ? "the line ends" : fmt::format("found '{}'", valid_utf8(found.substr(0, 40)));
    errors_.push_back({.file = file_,
                       .line = lines_.number(),
                       .column = 1,
                       .message = fmt::format("{} where {} should stand", what, wanted)});
  }

  void warn_of_lines(const char* what, const Skipped& skipped) {
    if (skipped.count == 0) return;
    model_.warnings.push_back({.level = Diagnostic::Level::warning,
                               .file = file_,
                               .line = skipped.first_line,
                               .column = 1,
                               .message = fmt::format("{} {}", skipped.count, what)});
  }

  Lines lines_;
  std::string file_;
  Model& model_;
  FaceList faces_;
  Diagnostics errors_;
  std::string joined_, body_name_;
  std::map<std::string, std::uint32_t> bodies_;
  std::uint32_t body_ = 0;
  bool body_known_ = false;
  std::uint64_t highest_ = 0;  // number of a point from 1, referred to before it was there
  int highest_line_ = 0;
  Skipped surfaces_, unknown_;
  const bool cut_line_;
};

}  // namespace

Diagnostics load_obj(std::string_view text, const std::string& file, double scale, Model& model) {
  model.format = "OBJ";
  ObjReader reader(text, file, model);
  if (Diagnostics errors = reader.read(); !errors.empty()) return errors;
  return take_faces(std::move(reader.faces()), file, scale, model);
}

}  // namespace gabarit
