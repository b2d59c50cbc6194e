#include "model/load_off.h"

#include <fmt/format.h>

#include "model/face_list.h"
#include "model/number_word.h"
#include "model/text_encoding.h"
#include "model/text_lines.h"

namespace gabarit {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& file)
      : lines_(text), file_(file), bytes_(text.size()) {}

  Diagnostics read() {
    if (!read_keyword() || !read_counts()) return errors_;
    for (std::uint64_t i = 0; i < points_ && errors_.empty(); ++i) read_point();
    for (std::uint64_t i = 0; i < face_count_ && errors_.empty(); ++i) read_face();
    if (errors_.empty() && next_line())
      fail(fmt::format("the file goes on after the {} faces that it announces", face_count_));
    return errors_;
  }

  FaceList& faces() { return faces_; }

 private:
  // The next line that holds anything but a comment.
  bool next_line() {
    while (lines_.next(line_)) {
      line_ = trimmed(without_comment(line_));
      if (!line_.empty()) return true;
    }
    line_ = {};
    return false;
  }

  // The next word, on a later line if need be; empty at the end of the file.
  std::string_view word() {
    std::string_view found = next_word(line_);
    if (found.empty() && next_line()) found = next_word(line_);
    return found;
  }

  // "OFF" behind the letters that say what else stands beside the points.
  bool read_keyword() {
    const std::string_view first = word();
    const std::size_t at = first.find("OFF");
    const bool known = at != std::string_view::npos &&
                       first.substr(0, at).find_first_not_of("STCN") == std::string_view::npos;
    if (!known) {
      return fail(first.find("4OFF") != std::string_view::npos || first.find("nOFF") != std::string_view::npos
                      ? "points of four or more dimensions cannot be read"
                      : "is not an OFF file: the first word should be 'OFF'");
    }
    // Some writers put the first number right behind the keyword.
    line_ = std::string_view(first.data() + at + 3,
                             static_cast<std::size_t>(line_.data() + line_.size() - first.data()) - at - 3);
    std::string_view rest = line_;
    if (next_word(rest) == "BINARY")
      return fail("binary OFF cannot be read; export it as ASCII OFF, PLY or STL");
    return true;
  }

  bool read_counts() {
    std::int64_t points = 0;
    std::int64_t faces = 0;
    if (!read_integer(word(), points) || !read_integer(word(), faces) || points < 0 || faces < 0)
      return fail("the numbers of points and faces should stand here");
    points_ = static_cast<std::uint64_t>(points);
    face_count_ = static_cast<std::uint64_t>(faces);
    line_ = {};  // the number of edges, which nobody keeps
    // A point takes six bytes at least, a face two; the last line may lack its end.
    if (points_ > bytes_ / 6 + 1 || face_count_ > bytes_ / 2 + 1) {
      return fail(
          fmt::format("the header announces {} points and {} faces, more than {} bytes can hold: the "
                      "file is cut short or damaged; export it again",
                      points, faces, bytes_));
    }
    faces_.points.reserve(points_);
    faces_.ends.reserve(face_count_);
    return true;
  }

  void read_point() {
    Vec3d p;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view found = word();
      if (!read_number(found, p[axis])) return unexpected(found, "a coordinate");
    }
    line_ = {};
    faces_.points.push_back(p);
  }

  void read_face() {
    std::int64_t corners = 0;
    std::string_view found = word();
    if (!read_integer(found, corners) || corners < 0) return unexpected(found, "a face's number of corners");
    for (std::int64_t i = 0; i < corners; ++i) {
      std::int64_t point = 0;
      found = word();
      if (!read_integer(found, point) || point < 0 || static_cast<std::uint64_t>(point) >= points_)
        return unexpected(found, fmt::format("the number of a point, 0 to {},", points_ - 1));
      faces_.corners.push_back(static_cast<std::uint32_t>(point));
    }
    line_ = {};
    faces_.end_face();
  }

  void unexpected(std::string_view found, const std::string& wanted) {
    const std::string what = found.empty() ? fmt::format("the file ends after {} points and {} faces",
                                                         faces_.points.size(), faces_.face_count())
                                           : fmt::format("found '{}'", valid_utf8(found.substr(0, 40)));
    fail(fmt::format("{} where {} should stand", what, wanted));
  }

  bool fail(std::string message) {
    errors_.push_back({.file = file_, .line = lines_.number(), .column = 1, .message = std::move(message)});
    return false;
  }

  Lines lines_;
  std::string file_;
  std::size_t bytes_;
  std::string_view line_;  // what is left of the current line
  std::uint64_t points_ = 0, face_count_ = 0;
  FaceList faces_;
  Diagnostics errors_;
};

}  // namespace

Diagnostics load_off(std::string_view text, const std::string& file, double scale, Model& model) {
  model.format = "OFF";
  OffReader reader(text, file);
  if (Diagnostics errors = reader.read(); !errors.empty()) return errors;
  return take_faces(std::move(reader.faces()), file, scale, model);
}

}  // namespace gabarit
