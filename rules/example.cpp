#include <fmt/format.h>

#include "rules/explain.h"

namespace gabarit {

namespace {

// A value that the reader accepts, growing with `nth` so that ranges do not end before they begin.
std::string value_of(const Parameter& parameter, int nth) {
  if (parameter.default_text) return *parameter.default_text;
  if (!parameter.choices.empty()) return parameter.choices.front();
  switch (parameter.dimension) {
    case Dimension::length: return fmt::format("{} mm", 100 * nth);
    case Dimension::area: return fmt::format("{} mm2", nth);
    case Dimension::angle: return fmt::format("{} deg", 10 * nth);
    case Dimension::point: return fmt::format("[{0} mm, {0} mm, {0} mm]", 100 * nth);
    case Dimension::direction: return "[0, 0, 1]";
    case Dimension::choice:
    case Dimension::text: return "\"tank*\"";
    case Dimension::number:
    case Dimension::count: break;
  }
  return fmt::format("{}", nth);
}

// Those that must be given; of selectors that only have optional ones, all.
std::string pairs(const std::vector<Parameter>& parameters, const std::string& variant, bool with_defaults) {
  bool all_optional = true;
  for (const Parameter& p : parameters) all_optional = all_optional && p.optional;
  std::string text;
  int nth = 0;
  for (const Parameter& p : parameters) {
    if ((p.optional && !all_optional) || (p.default_text && !with_defaults)) continue;
    const std::string value = &p == &parameters.front() && !variant.empty() ? variant : value_of(p, ++nth);
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", p.name, value);
  }
  return text;
}

}  // namespace

std::string example(const Selector& selector) {
  return fmt::format("where:\n  {}: {{{}}}\n", selector.name,
                     pairs(selector.parameters, selector.variant, false));
}

std::string example(const Measure& measure) {
  const Parameter limit{.name = "at least", .dimension = measure.dimension, .documentation = {}};
  std::string value = measure.dimension == Dimension::length ? "4 mm" : value_of(limit, 1);
  std::string others = pairs(measure.parameters, {}, true);
  if (others.size() > 60) others = pairs(measure.parameters, {}, false);  // a line has 90 columns
  return fmt::format("require:\n  {}: {{at least: {}{}{}}}\n", measure.name, value,
                     others.empty() ? "" : ", ", others);
}

}  // namespace gabarit
