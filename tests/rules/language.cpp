#include "tests/rules/language.h"

#include <array>

namespace gabarit::language {

static Field measure_nothing(const Scene&, const Setup&, const Region&, const Arguments&) { return {}; }

static const Measure radius{.name = "radius",
                            .summary = "Radius.",
                            .documentation = "How round it is.",
                            .symbol = "R",
                            .parameters = {{.name = "method",
                                            .dimension = Dimension::choice,
                                            .documentation = "How it is measured.",
                                            .default_text = "turning",
                                            .choices = {"turning", "sphere placement"}},
                                           {.name = "window",
                                            .dimension = Dimension::length,
                                            .documentation = "Half the width of the window.",
                                            .default_text = "2 mm",
                                            .least = 0.01,
                                            .greatest = 100}},
                            .measure = measure_nothing};
static const Measure angle{.name = "angle",
                           .summary = "Angle.",
                           .documentation = "How steep it is.",
                           .symbol = "α",
                           .dimension = Dimension::angle,
                           .measure = measure_nothing};

Catalogue catalogue() {
  static constexpr std::array measures{&radius, &angle};
  Catalogue result;
  result.measures = measures;
  return result;
}

Result<RuleSet> read(const std::string& text) { return read_rules_text(text, "r.yaml", catalogue()); }

std::string with_where(const std::string& where) {
  return "gabarit: 1\nid: set\nrules:\n  - id: rule\n    where: " + where +
         "\n    require: {radius: {at least: 4 mm}}\n";
}

std::string with_require(const std::string& require) {
  return "gabarit: 1\nid: set\nrules:\n  - id: rule\n    require: " + require + "\n";
}

std::string errors(const std::string& text) {
  const auto rules = read(text);
  if (rules) return "fine";
  std::string all;
  for (const Diagnostic& diagnostic : rules.error()) all += to_string(diagnostic);
  return all;
}

std::vector<std::string> messages(const std::string& text) {
  std::vector<std::string> all;
  const auto rules = read(text);
  if (rules) return all;
  for (const Diagnostic& d : rules.error()) {
    all.push_back(d.hint.empty() ? d.message : d.message + " (" + d.hint + ")");
  }
  return all;
}

}  // namespace gabarit::language
