#include "rules/quantity.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "rules/nearest_name.h"

namespace gabarit {

namespace {

struct UnitName {
  std::string_view name;
  Dimension dimension;
  double factor;
};

constexpr std::array units{
    UnitName{"mm", Dimension::length, 1.0},   UnitName{"cm", Dimension::length, 10.0},
    UnitName{"m", Dimension::length, 1000.0}, UnitName{"in", Dimension::length, 25.4},
    UnitName{"mm2", Dimension::area, 1.0},    UnitName{"cm2", Dimension::area, 100.0},
    UnitName{"m2", Dimension::area, 1e6},     UnitName{"in2", Dimension::area, 645.16},
    UnitName{"mm²", Dimension::area, 1.0},    UnitName{"cm²", Dimension::area, 100.0},
    UnitName{"m²", Dimension::area, 1e6},     UnitName{"deg", Dimension::angle, std::numbers::pi / 180.0},
    UnitName{"rad", Dimension::angle, 1.0}};

const char* kind(Dimension dimension) {
  switch (dimension) {
    case Dimension::length: return "a length";
    case Dimension::area: return "an area";
    case Dimension::angle: return "an angle";
    case Dimension::count: return "a whole number";
    default: return "a number";
  }
}

bool has_unit(Dimension dimension) {
  return dimension == Dimension::length || dimension == Dimension::area || dimension == Dimension::angle;
}

std::string units_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::length: return "units of a length: mm, cm, m, in";
    case Dimension::area: return "units of an area: mm2, cm2, m2, in2";
    default: return "units of an angle: deg, rad";
  }
}

const char* usual_unit(Dimension dimension) {
  return dimension == Dimension::length ? "mm" : dimension == Dimension::area ? "mm2" : "deg";
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

struct Number {
  double value;
  std::string_view rest;  // what follows it, trimmed
};

Complaint not_a_number(std::string_view text, Dimension dimension) {
  const std::string example =
      has_unit(dimension) ? fmt::format("such as `4 {}`", usual_unit(dimension)) : "such as `4`";
  return {fmt::format("`{}` is not {}", text, kind(dimension)), "a decimal number is wanted, " + example};
}

Result<Number, Complaint> leading_number(std::string_view text, Dimension dimension) {
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  const std::string_view unsigned_part = digits.starts_with('-') ? digits.substr(1) : digits;
  const bool begins = !unsigned_part.empty() &&
                      (is_digit(unsigned_part[0]) ||
                       (unsigned_part[0] == '.' && unsigned_part.size() > 1 && is_digit(unsigned_part[1])));
  if (!begins || (text.starts_with('+') && digits.starts_with('-'))) return not_a_number(text, dimension);
  Number number{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number.value);
  if (error != std::errc{}) {
    return Complaint{fmt::format("`{}` is outside the range of numbers", text), {}};
  }
  number.rest = trimmed(digits.substr(static_cast<std::size_t>(end - digits.data())));
  return number;
}

Complaint no_unit(std::string_view text, Dimension dimension) {
  return {fmt::format("`{}` has no unit", text),
          fmt::format("write `{} {}`; {}", text, usual_unit(dimension), units_of(dimension))};
}

Complaint unknown_unit(std::string_view text, std::string_view unit, Dimension dimension) {
  if (unit.starts_with(',')) return {fmt::format("`{}` has a comma", text), "write a decimal point"};
  std::vector<std::string> known;
  for (const UnitName& u : units) {
    if (u.dimension == dimension) known.emplace_back(u.name);
  }
  const auto nearest = nearest_name(std::string(unit), known);
  const std::string question = nearest ? fmt::format("did you mean `{}`? ", *nearest) : std::string();
  return {fmt::format("unknown unit `{}`", unit), question + units_of(dimension)};
}

Result<double, Complaint> with_unit(std::string_view text, const Number& number, Dimension dimension) {
  if (number.rest.empty()) return no_unit(text, dimension);
  for (const UnitName& unit : units) {
    if (unit.name != number.rest) continue;
    if (unit.dimension != dimension) {
      return Complaint{fmt::format("`{}` is {}, {} is wanted", text, kind(unit.dimension), kind(dimension)),
                       units_of(dimension)};
    }
    const double value = number.value * unit.factor;
    if (std::isfinite(value)) return value;
    return Complaint{fmt::format("`{}` is outside the range of numbers", text), {}};
  }
  return unknown_unit(text, number.rest, dimension);
}

}  // namespace

Result<double, Complaint> read_quantity(const std::string& written, Dimension dimension) {
  const std::string_view text = trimmed(written);
  const auto number = leading_number(text, dimension);
  if (!number) return number.error();
  if (has_unit(dimension)) return with_unit(text, *number, dimension);
  if (!number->rest.empty()) {
    return Complaint{fmt::format("`{}` has something after the number", text),
                     fmt::format("{} without a unit is wanted", kind(dimension))};
  }
  if (dimension == Dimension::count && (number->value != std::floor(number->value) || number->value < 0)) {
    return not_a_number(text, dimension);
  }
  return number->value;
}

std::string quantity_text(double value, Dimension dimension) {
  if (dimension == Dimension::angle) {
    return fmt::format("{} deg", std::round(value * 180.0 / std::numbers::pi * 1e9) / 1e9);
  }
  return has_unit(dimension) ? fmt::format("{} {}", value, usual_unit(dimension)) : fmt::format("{}", value);
}

}  // namespace gabarit
