#include "rules/explain.h"

#include <algorithm>

#include <fmt/format.h>

#include "rules/nearest_name.h"
#include "rules/wrapped.h"

namespace gabarit {

namespace {

constexpr int width = 90;

std::string heading(const std::string& text) { return text + "\n" + std::string(text.size(), '-') + "\n"; }

const char* kind(const Parameter& parameter) {
  switch (parameter.dimension) {
    case Dimension::length: return "a length";
    case Dimension::area: return "an area";
    case Dimension::angle: return "an angle";
    case Dimension::number: return "a number";
    case Dimension::count: return "a whole number";
    case Dimension::choice: return "one of";
    case Dimension::text: return "text";
    case Dimension::point: return "three lengths";
    case Dimension::direction: break;
  }
  return parameter.choices.empty() ? "three numbers" : "three numbers, or one of";
}

std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += fmt::format("{}{}", text.empty() ? "" : ", ", name);
  return text;
}

std::string describe(const Parameter& p) {
  std::string what = kind(p);
  if (!p.choices.empty()) what += fmt::format(" {}", list_of(p.choices));
  if (p.least > -1e300) what += fmt::format(", at least {}", quantity_text(p.least, p.dimension));
  if (p.greatest < 1e300) what += fmt::format(", at most {}", quantity_text(p.greatest, p.dimension));
  what += p.default_text ? fmt::format("; default {}", *p.default_text)
          : p.optional   ? "; may be left out"
                         : "; required";
  return fmt::format("  {}\n", p.name) + wrapped(what, width, 6) + wrapped(p.documentation, width, 6);
}

std::string parameters_of(const std::vector<Parameter>& parameters) {
  if (parameters.empty()) return "\nNo parameters.\n";
  std::string text = "\nParameters\n";
  for (const Parameter& parameter : parameters) text += describe(parameter);
  return text;
}

std::string indented(const std::string& text) {
  std::string result = "  ";
  for (std::size_t i = 0; i < text.size(); ++i) {
    result += text[i];
    if (text[i] == '\n' && i + 1 < text.size()) result += "  ";
  }
  return result;
}

template <class Check>
std::string page(const Check& check, const std::string& title) {
  return heading(title) + wrapped(check.summary, width) + "\n" + wrapped(check.documentation, width) +
         parameters_of(check.parameters) + "\nExample\n" + indented(example(check));
}

std::string page_of(const Selector& selector) {
  const std::string variant = selector.variant.empty() ? "" : fmt::format(" ({})", selector.variant);
  return page(selector, selector.name + variant + ", a selector");
}

std::string page_of(const Measure& measure) {
  return page(measure, fmt::format("{}, a measure", measure.name)) + "  # or: at most, between: [a, b]\n";
}

template <class Check>
std::string summaries(std::span<const Check* const> checks) {
  std::string text;
  for (const Check* check : checks)
    text += fmt::format("  {}\n", check->name) + wrapped(check->summary, width, 6);
  return text;
}

}  // namespace

std::string explain_all(const Catalogue& catalogue) {
  return "A rule says where to look and what is required there:\n\n"
         "  - id: column-r4\n"
         "    where: {contact: {probe: vertical cylinder, diameter: 300 mm}}\n"
         "    require: {radius: {at least: 4 mm}}\n\n"
         "Selectors, in `where` (combine them by `all: [...]`, `any: [...]` and `not:`)\n" +
         summaries(catalogue.selectors) +
         "\nMeasures, in `require` (with `at least`, `at most` or `between: [a, b]`)\n" +
         summaries(catalogue.measures) + "\n`gabarit explain NAME` tells more about one of them.\n";
}

Result<std::string, Complaint> explain(const std::string& name, const Catalogue& catalogue) {
  std::string text;
  for (const Selector* selector : catalogue.selectors_named(name)) {
    text += fmt::format("{}{}", text.empty() ? "" : "\n", page_of(*selector));
  }
  const Measure* measure = catalogue.measure_named(name);
  if (measure) text += fmt::format("{}{}", text.empty() ? "" : "\n", page_of(*measure));
  if (!text.empty()) return text;
  std::vector<std::string> known = catalogue.selector_names();
  for (const std::string& other : catalogue.measure_names()) known.push_back(other);
  return Complaint{fmt::format("nothing is called `{}`", name), name_hint(name, known)};
}

}  // namespace gabarit
