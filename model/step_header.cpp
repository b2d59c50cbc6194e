#include "model/step_header.h"

#include <algorithm>

#include <fmt/format.h>

#include "model/text_encoding.h"

namespace gabarit {
namespace {

// The last parameter of the record whose parameters begin at `at`, which goes to the end of the record or, if
// there is none, of the file.
std::string_view last_parameter(std::string_view bytes, std::size_t& at) {
  int depth = 0;
  bool in_text = false;
  std::size_t begin = at;
  for (; at < bytes.size(); ++at) {
    const char c = bytes[at];
    if (c == '\'') in_text = !in_text;
    if (in_text) continue;
    if (c == '(') ++depth;
    if (c == ',' && depth == 0) begin = at + 1;
    if (c == ')' && depth-- == 0) return bytes.substr(begin, at - begin);
  }
  return {};
}

std::size_t without_link(std::string_view bytes, std::string_view key) {
  std::size_t count = 0;
  for (std::size_t at = bytes.find(key); at != std::string_view::npos; at = bytes.find(key, at)) {
    at = bytes.find_first_not_of(" \r\n\t", at + key.size());
    if (at == std::string_view::npos) break;
    if (bytes[at++] != '(') continue;
    count += last_parameter(bytes, at).find('#') == std::string_view::npos ? 1 : 0;
  }
  return count;
}

}  // namespace

Diagnostics step_errors(std::string_view bytes, const std::string& file) {
  const auto error = [&](std::string message) {
    return Diagnostics{{.file = file, .message = std::move(message)}};
  };
  if (bytes.substr(0, 4096).find("ISO-10303-21") == std::string_view::npos)
    return error("does not begin with ISO-10303-21: it is no STEP file");
  if (bytes.find("DATA") == std::string_view::npos) return error("has no DATA section");
  const std::string_view end = bytes.substr(bytes.size() - std::min<std::size_t>(bytes.size(), 4096));
  if (end.find("END-ISO-10303-21") == std::string_view::npos)
    return error("is cut off: END-ISO-10303-21 is missing at its end; export or copy it again");
  return {};
}

std::string step_format(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 65536);
  const std::size_t key = head.find("FILE_SCHEMA");
  if (key == std::string_view::npos) return "STEP";
  const std::size_t open = head.find('\'', key);
  const std::size_t close = open == std::string_view::npos ? open : head.find('\'', open + 1);
  if (close == std::string_view::npos) return "STEP";
  // AP242 names its schema with an object identifier behind it.
  std::string schema = valid_utf8(head.substr(open + 1, std::min<std::size_t>(close - open - 1, 80)));
  schema = schema.substr(0, schema.find_first_of(" {"));
  return schema.empty() ? "STEP" : fmt::format("STEP ({})", schema);
}

std::vector<std::string> step_conversion_units(std::string_view bytes) {
  constexpr std::string_view key = "CONVERSION_BASED_UNIT";
  std::vector<std::string> names;
  for (std::size_t at = bytes.find(key); at != std::string_view::npos;
       at = bytes.find(key, at + key.size())) {
    const std::size_t open = bytes.find_first_not_of(" \r\n\t(", at + key.size());
    if (open == std::string_view::npos || bytes[open] != '\'') continue;
    const std::size_t close = bytes.find('\'', open + 1);
    if (close == std::string_view::npos) break;
    std::string name = valid_utf8(bytes.substr(open + 1, std::min<std::size_t>(close - open - 1, 40)));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

std::size_t step_bodies_of_facets(std::string_view bytes) {
  return without_link(bytes, "TESSELLATED_SOLID") + without_link(bytes, "TESSELLATED_SHELL");
}

}  // namespace gabarit
