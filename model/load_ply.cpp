#include "model/load_ply.h"

#include <fmt/format.h>

#include "model/face_list.h"
#include "model/ply_header.h"
#include "model/ply_values.h"
#include "model/text_encoding.h"

namespace gabarit {
namespace {

bool holds_corners(const PlyProperty& p) {
  return p.count.has_value() && (p.name == "vertex_indices" || p.name == "vertex_index");
}

// What is wrong with what the header announces; empty when it can be read.
std::string problem_of(const PlyElement& element, PlyFormat format, std::uint64_t bytes) {
  if (element.count == 0) return {};
  int axes = 0;
  int corner_lists = 0;
  for (const PlyProperty& p : element.properties) {
    axes += !p.count && (p.name == "x" || p.name == "y" || p.name == "z");
    corner_lists += holds_corners(p);
  }
  if (element.name == "vertex" && axes != 3)
    return "the points should have the properties x, y and z, each once";
  if (element.name == "face" && corner_lists != 1)
    return "the faces should have one list called vertex_indices";
  if (element.name != "face" && corner_lists > 0) {
    return fmt::format("the element '{}' holds faces in a form that cannot be read; export plain faces",
                       element.name);
  }
  // The last line of a text may lack its end.
  const std::uint64_t least = element.least_bytes(format);
  if (least > 0 && element.count > (bytes + 1) / least) {
    return fmt::format(
        "the header announces {} of the element '{}', more than {} bytes can hold: the file is cut "
        "short or damaged; export it again",
        element.count, element.name, bytes);
  }
  return {};
}

template <class Values>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, std::string_view data, const std::string& file)
      : header_(header), values_(data, header.lines), file_(file) {}

  Diagnostics read() {
    for (const PlyElement& element : header_.elements) {
      if (std::string problem = problem_of(element, header_.format, values_.bytes_left()); !problem.empty())
        fail(std::move(problem));
      if (!errors_.empty()) return errors_;
      read_element(element);
    }
    if (errors_.empty() && highest_ >= static_cast<double>(faces_.points.size()) && !faces_.corners.empty()) {
      fail(fmt::format("a face refers to point {}, the last one is {}", highest_,
                       static_cast<std::int64_t>(faces_.points.size()) - 1));
    }
    if (errors_.empty() && values_.has_more())
      fail("the file goes on after what its header announces; export it again");
    return errors_;
  }

  FaceList& faces() { return faces_; }

 private:
  void read_element(const PlyElement& element) {
    if (element.properties.empty()) return;
    if (element.name == "vertex") faces_.points.reserve(element.count);
    if (element.name == "face") faces_.ends.reserve(element.count);
    for (row_ = 0; row_ < element.count && errors_.empty(); ++row_) {
      point_ = {};
      for (const PlyProperty& property : element.properties) {
        if (errors_.empty()) read_property(element, property);
      }
      if (element.name == "vertex") faces_.points.push_back(point_);
      if (element.name == "face") faces_.end_face();
    }
  }

  void read_property(const PlyElement& element, const PlyProperty& property) {
    if (property.count) return read_list(element, property);
    const double value = next(element, property.type);
    if (element.name != "vertex") return;
    if (property.name == "x") point_.x = value;
    if (property.name == "y") point_.y = value;
    if (property.name == "z") point_.z = value;
  }

  void read_list(const PlyElement& element, const PlyProperty& property) {
    const double length = next(element, *property.count);
    if (!errors_.empty()) return;
    const auto most = static_cast<double>((values_.bytes_left() + 1) / Values::bytes_of(property.type));
    if (length < 0 || length > most) {
      return fail(
          fmt::format("{} {} has a list of {} values, {} bytes are left: the file is cut short or damaged; "
                      "export it again",
                      element.name, row_ + 1, length, values_.bytes_left()));
    }
    const bool corners = element.name == "face" && holds_corners(property);
    for (double i = 0; i < length && errors_.empty(); ++i) {
      const double value = next(element, property.type);
      if (corners && errors_.empty()) add_corner(value);
    }
  }

  // Faces may stand before the points.
  void add_corner(double value) {
    if (!(value >= 0) || value >= static_cast<double>(most_points) ||
        value != static_cast<std::uint32_t>(value))
      return fail(fmt::format("face {} refers to point {}", row_ + 1, value));
    highest_ = std::max(highest_, value);
    faces_.corners.push_back(static_cast<std::uint32_t>(value));
  }

  double next(const PlyElement& element, PlyType type) {
    double value = 0;
    if (values_.next(type, value)) return value;
    const std::string_view found = values_.found();
    fail(found.empty() ? fmt::format("the file ends in '{}' {} of {}: it is cut short; export it again",
                                     element.name, row_ + 1, element.count)
                       : fmt::format("found '{}' where a {} should stand", valid_utf8(found.substr(0, 40)),
                                     is_integer(type) ? "whole number" : "number"));
    return 0;
  }

  void fail(std::string message) {
    const int line = values_.line();
    errors_.push_back(
        {.file = file_, .line = line, .column = line > 0 ? 1 : 0, .message = std::move(message)});
  }

  const PlyHeader& header_;
  Values values_;
  std::string file_;
  FaceList faces_;
  Diagnostics errors_;
  std::uint64_t row_ = 0;
  Vec3d point_;
  double highest_ = 0;
};

template <class Values>
Diagnostics read_with(const PlyHeader& header, std::string_view bytes, const std::string& file, double scale,
                      Model& model) {
  PlyReader<Values> reader(header, bytes.substr(header.bytes), file);
  if (Diagnostics errors = reader.read(); !errors.empty()) return errors;
  return take_faces(std::move(reader.faces()), file, scale, model);
}

}  // namespace

Diagnostics load_ply(std::string_view bytes, const std::string& file, double scale, Model& model) {
  model.format = "PLY";
  const Result<PlyHeader> header = read_ply_header(bytes, file);
  if (!header) return header.error();
  switch (header->format) {
    case PlyFormat::ascii: break;
    case PlyFormat::little_endian:
      return read_with<PlyBytes<std::endian::little>>(*header, bytes, file, scale, model);
    case PlyFormat::big_endian:
      return read_with<PlyBytes<std::endian::big>>(*header, bytes, file, scale, model);
  }
  return read_with<PlyWords>(*header, bytes, file, scale, model);
}

}  // namespace gabarit
