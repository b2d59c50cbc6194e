#include "rules/read_value.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "rules/nearest_name.h"

namespace gabarit {

namespace {

Result<Value, Complaint> within_range(const Parameter& parameter, const std::string& text, double value) {
  const char* wanted = value < parameter.least ? "least" : "most";
  const double bound = value < parameter.least ? parameter.least : parameter.greatest;
  if (value >= parameter.least && value <= parameter.greatest) return Value(value);
  return Complaint{
      fmt::format("`{}` is out of range", text),
      fmt::format("`{}` is at {} {}", parameter.name, wanted, quantity_text(bound, parameter.dimension))};
}

// "[a, b, c]" → a, b, c; nothing when it is not three things in brackets.
std::vector<std::string> three_parts(const std::string& text) {
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return {};
  std::vector<std::string> parts(1);
  for (const char c : text.substr(1, text.size() - 2)) {
    if (c == ',') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts.size() == 3 ? parts : std::vector<std::string>{};
}

Result<Value, Complaint> read_vector(const Parameter& parameter, const std::string& text) {
  const bool point = parameter.dimension == Dimension::point;
  const std::vector<std::string> parts = three_parts(text);
  if (parts.empty()) {
    return Complaint{fmt::format("`{}` is not a {}", text, point ? "point" : "direction"),
                     point ? "three lengths are wanted, such as `[0 mm, 10 mm, 250 mm]`"
                           : "three numbers are wanted, such as `[0, 0, 1]`"};
  }
  Vec3d result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto part =
        read_quantity(parts[static_cast<std::size_t>(axis)], point ? Dimension::length : Dimension::number);
    if (!part) return part.error();
    result[axis] = *part;
  }
  const double size = length(result);  // overflows to infinity, underflows to 0
  if (!point && !(size > 0 && std::isfinite(size))) {
    return Complaint{fmt::format("`{}` points nowhere", text), "a direction has a length of about 1"};
  }
  return Value(result);
}

bool is_choice(const Parameter& parameter, const std::string& text) {
  return std::find(parameter.choices.begin(), parameter.choices.end(), text) != parameter.choices.end();
}

Complaint not_a_choice(const Parameter& parameter, const std::string& text) {
  return {fmt::format("unknown {} `{}`", parameter.name, text), name_hint(text, parameter.choices)};
}

}  // namespace

Result<Value, Complaint> read_value(const Parameter& parameter, const std::string& text) {
  switch (parameter.dimension) {
    case Dimension::text:
      if (text.empty()) return Complaint{fmt::format("`{}` is empty", parameter.name), {}};
      return Value(text);
    case Dimension::choice:
      if (!is_choice(parameter, text)) return not_a_choice(parameter, text);
      return Value(text);
    case Dimension::direction:
      if (is_choice(parameter, text)) return Value(text);
      if (!parameter.choices.empty() && !text.starts_with('[')) return not_a_choice(parameter, text);
      return read_vector(parameter, text);
    case Dimension::point: return read_vector(parameter, text);
    default: break;
  }
  const auto quantity = read_quantity(text, parameter.dimension);
  if (!quantity) return quantity.error();
  return within_range(parameter, text, *quantity);
}

std::vector<std::string> fill_defaults(std::span<const Parameter> parameters, Arguments& arguments) {
  std::vector<std::string> missing;
  for (const Parameter& parameter : parameters) {
    if (arguments.has(parameter.name)) continue;
    if (parameter.default_text) {
      const auto value = read_value(parameter, *parameter.default_text);
      assert(value);  // every descriptor's defaults are read by a test
      if (value) arguments.set(parameter.name, *value);
    } else if (!parameter.optional) {
      missing.push_back(parameter.name);
    }
  }
  return missing;
}

}  // namespace gabarit
