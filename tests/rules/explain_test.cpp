#include "rules/explain.h"

#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rules/read_value.h"
#include "rules/source_text.h"
#include "rules/wrapped.h"
#include "tests/rules/language.h"

namespace gabarit {
namespace {

using testing::HasSubstr;

TEST(Explain, a_page_has_definition_parameters_and_an_example) {
  const auto text = explain("height");
  ASSERT_TRUE(text);
  EXPECT_THAT(*text, testing::StartsWith("height, a selector\n------------------\n"
                                         "Facets that reach into a band of heights above ground.\n"));
  EXPECT_THAT(*text, HasSubstr("\nParameters\n  from\n      a length; may be left out\n      Lower end;"));
  EXPECT_THAT(*text, HasSubstr("\nExample\n  where:\n    height: {from: 100 mm, to: 200 mm}\n"));
  const auto measure = explain("radius", language::catalogue());
  ASSERT_TRUE(measure);
  EXPECT_THAT(*measure, HasSubstr("one of turning, sphere placement; default turning\n"));
  EXPECT_THAT(*measure, HasSubstr("a length, at least 0.01 mm, at most 100 mm; default 2 mm\n"));
}

TEST(Explain, the_list_names_everything) {
  const Catalogue catalogue = language::catalogue();
  const std::string text = explain_all(catalogue);
  for (const Selector* selector : catalogue.selectors)
    EXPECT_THAT(text, HasSubstr("\n  " + selector->name + "\n"));
  for (const Measure* measure : catalogue.measures)
    EXPECT_THAT(text, HasSubstr("\n  " + measure->name + "\n"));
}

TEST(Explain, an_unknown_name_gets_the_nearest) {
  const auto text = explain("radus", language::catalogue());
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().message, "nothing is called `radus`");
  EXPECT_EQ(
      text.error().hint,
      "did you mean `radius`? known are: `contact`, `height`, `box`, `facing`, `body`, `radius`, `angle`");
}

void expect_lines_fit(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(character_count(line), 90) << line;
}

TEST(Explain, lines_fit_90_columns) {
  expect_lines_fit(explain_all());
  for (const Selector* selector : all_selectors()) expect_lines_fit(*explain(selector->name));
  for (const Measure* measure : all_measures()) expect_lines_fit(*explain(measure->name));
}

// "a:\n  b\n" as an entry of a rule, indented.
std::string rule_with(const std::string& entry, const std::string& require) {
  std::string text = "gabarit: 1\nid: set\nrules:\n  - id: rule\n";
  std::istringstream lines(entry + require);
  for (std::string line; std::getline(lines, line);) text += fmt::format("    {}\n", line);
  return text;
}

TEST(Explain, every_example_is_accepted_by_the_reader) {
  Catalogue every = language::catalogue();
  for (const Selector* selector : every.selectors) {
    EXPECT_EQ(language::errors(rule_with(example(*selector), "require: {radius: {at least: 1 mm}}\n")),
              "fine");
  }
  for (const Measure* measure : every.measures)
    EXPECT_EQ(language::errors(rule_with(example(*measure), "")), "fine");
  for (const Measure* measure : all_measures()) {
    EXPECT_TRUE(read_rules_text(rule_with(example(*measure), ""), "r.yaml")) << example(*measure);
  }
}

void expect_sound(const std::string& name, const std::vector<Parameter>& parameters) {
  for (const Parameter& p : parameters) {
    EXPECT_FALSE(p.documentation.empty()) << name << " " << p.name;
    EXPECT_LE(p.least, p.greatest);
    EXPECT_TRUE(!p.default_text || read_value(p, *p.default_text)) << name << " " << p.name;
  }
}

TEST(Explain, every_descriptor_is_documented_and_its_defaults_can_be_read) {
  for (const Selector* selector : all_selectors()) {
    EXPECT_FALSE(selector->summary.empty() || selector->documentation.empty()) << selector->name;
    EXPECT_TRUE(selector->select && selector->sentence) << selector->name;
    expect_sound(selector->name, selector->parameters);
  }
  for (const Measure* measure : all_measures()) {
    EXPECT_FALSE(measure->summary.empty() || measure->documentation.empty() || measure->symbol.empty());
    EXPECT_TRUE(measure->measure) << measure->name;
    expect_sound(measure->name, measure->parameters);
  }
}

TEST(Wrapped, breaks_at_spaces_and_keeps_paragraphs_and_lists) {
  EXPECT_EQ(wrapped("one two three", 7), "one two\nthree\n");
  EXPECT_EQ(wrapped("a b\nc\n\nd", 80), "a b c\n\nd\n");
  EXPECT_EQ(wrapped("list:\n- a\n- b", 80, 2), "  list:\n  - a\n  - b\n");
  EXPECT_EQ(wrapped("ααα βββ γγγ", 7), "ααα βββ\nγγγ\n") << "characters, not bytes";
  EXPECT_EQ(wrapped("unbreakable x", 5), "unbreakable\nx\n");
  EXPECT_EQ(wrapped("", 5), "");
}

}  // namespace
}  // namespace gabarit
