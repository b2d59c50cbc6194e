#include "model/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "model/number_word.h"
#include "model/text_encoding.h"
#include "model/text_lines.h"

namespace gabarit {
namespace {

constexpr std::size_t longest_header = std::size_t{1} << 20;

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_names{{{"char", PlyType::int8},
                                                                           {"uchar", PlyType::uint8},
                                                                           {"short", PlyType::int16},
                                                                           {"ushort", PlyType::uint16},
                                                                           {"int", PlyType::int32},
                                                                           {"uint", PlyType::uint32},
                                                                           {"float", PlyType::float32},
                                                                           {"double", PlyType::float64},
                                                                           {"int8", PlyType::int8},
                                                                           {"uint8", PlyType::uint8},
                                                                           {"int16", PlyType::int16},
                                                                           {"uint16", PlyType::uint16},
                                                                           {"int32", PlyType::int32},
                                                                           {"uint32", PlyType::uint32},
                                                                           {"float32", PlyType::float32},
                                                                           {"float64", PlyType::float64}}};

constexpr std::array<std::pair<std::string_view, PlyFormat>, 3> format_names{
    {{"ascii", PlyFormat::ascii},
     {"binary_little_endian", PlyFormat::little_endian},
     {"binary_big_endian", PlyFormat::big_endian}}};

template <class Named>
bool find_named(const Named& all, std::string_view word, auto& value) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == word; });
  if (found == all.end()) return false;
  value = found->second;
  return true;
}

// Each gives what is wrong with the rest of its line; empty when nothing is.
std::string read_format(std::string_view line, PlyHeader& header) {
  return find_named(format_names, next_word(line), header.format)
             ? ""
             : "the format should be ascii, binary_little_endian or binary_big_endian";
}

std::string read_element(std::string_view line, PlyHeader& header) {
  PlyElement element{.name = valid_utf8(next_word(line)), .properties = {}};
  std::int64_t count = 0;
  if (!read_integer(next_word(line), count) || count < 0) return "the number of elements is no whole number";
  element.count = static_cast<std::uint64_t>(count);
  const bool known = std::any_of(header.elements.begin(), header.elements.end(),
                                 [&](const PlyElement& one) { return one.name == element.name; });
  if (known) return fmt::format("two elements are called '{}'", element.name);
  header.elements.push_back(std::move(element));
  return {};
}

std::string read_property(std::string_view line, PlyHeader& header) {
  if (header.elements.empty()) return "a property stands before the first element";
  PlyProperty property{.name = {}, .count = {}};
  std::string_view word = next_word(line);
  if (word == "list") {
    PlyType count{};
    if (!find_named(type_names, next_word(line), count) || !is_integer(count))
      return "the type of a list's length is unknown or no whole number";
    property.count = count;
    word = next_word(line);
  }
  if (!find_named(type_names, word, property.type))
    return fmt::format("'{}' is no type that PLY knows", valid_utf8(word.substr(0, 40)));
  property.name = valid_utf8(next_word(line));
  header.elements.back().properties.push_back(std::move(property));
  return {};
}

// Where lines end in a lone CR, a line feed behind the last one is the data's first byte.
std::size_t data_begin(std::string_view start, const Lines& lines) {
  const std::size_t at = start.size() - lines.rest().size();
  const std::size_t first_end = start.find_first_of("\r\n");
  const bool lone_cr = start[first_end] == '\r' && start[first_end + 1] != '\n';
  return lone_cr && start[at - 1] == '\n' ? at - 1 : at;
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8: return 1;
    case PlyType::int16:
    case PlyType::uint16: return 2;
    case PlyType::float64: return 8;
    default: return 4;
  }
}

std::uint64_t PlyElement::least_bytes(PlyFormat format) const {
  if (format == PlyFormat::ascii) return 2 * properties.size();
  std::uint64_t sum = 0;
  for (const PlyProperty& p : properties) sum += size_of(p.count.value_or(p.type));
  return sum;
}

Result<PlyHeader> read_ply_header(std::string_view bytes, const std::string& file) {
  const std::string_view start = bytes.substr(0, longest_header);
  Lines lines(start);
  const auto refuse = [&](std::string message) {
    return Diagnostics{{.file = file, .line = lines.number(), .column = 1, .message = std::move(message)}};
  };
  PlyHeader header;
  std::string_view line;
  if (!lines.next(line) || trimmed(line) != "ply")
    return refuse("is not a PLY file: the first line should be 'ply'");
  bool format_read = false;
  while (lines.next(line)) {
    const std::string_view key = next_word(line);
    std::string problem;
    if (key == "end_header") {
      if (!format_read) return refuse("the PLY header has no 'format'");
      header.bytes = data_begin(start, lines);
      header.lines = lines.number();
      return header;
    }
    if (key == "format") {
      problem = read_format(line, header);
      format_read = true;
    } else if (key == "element") {
      problem = read_element(line, header);
    } else if (key == "property") {
      problem = read_property(line, header);
    } else if (!key.empty() && key != "comment" && key != "obj_info") {
      problem = fmt::format("found '{}' in the PLY header", valid_utf8(key.substr(0, 40)));
    }
    if (!problem.empty()) return refuse(std::move(problem));
  }
  return refuse("the PLY header has no 'end_header'");
}

}  // namespace gabarit
