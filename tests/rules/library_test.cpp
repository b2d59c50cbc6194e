#include <filesystem>

#include <gtest/gtest.h>

#include "checks/thickness.h"
#include "rules/engine.h"
#include "tests/rules/language.h"

namespace gabarit {
namespace {

std::vector<std::filesystem::path> files() {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(GABARIT_SOURCE_DIR "/rules/library")) {
    found.push_back(entry.path());
  }
  return found;
}

// With the measures that exist and those that only tests know.
Catalogue every_measure() {
  static const std::vector<const Measure*> measures = [] {
    std::vector<const Measure*> all(all_measures().begin(), all_measures().end());
    const Catalogue real;
    for (const Measure* measure : language::catalogue().measures) {
      if (!real.measure_named(measure->name)) all.push_back(measure);
    }
    return all;
  }();
  Catalogue catalogue = language::catalogue();
  catalogue.measures = measures;
  return catalogue;
}

TEST(Library, every_file_is_read_and_named_after_its_id) {
  std::vector<RuleSet> sets;
  for (const auto& file : files()) {
    const auto rules = read_rules(file, every_measure());
    ASSERT_TRUE(rules) << to_string(rules.error().at(0));
    EXPECT_EQ(rules->id, file.stem().string());
    EXPECT_FALSE(rules->revision.empty());
    EXPECT_FALSE(rules->source.document.empty() || rules->source.status.empty());
    sets.push_back(*rules);
  }
  ASSERT_FALSE(sets.empty());
  EXPECT_TRUE(check_selection(sets, {}).empty()) << "all of them can be checked in one run";
}

TEST(Library, the_motorcycle_column_asks_for_r4_and_notes_r3_2) {
  const auto read =
      read_rules(GABARIT_SOURCE_DIR "/rules/library/motorcycle-column.yaml", language::catalogue());
  ASSERT_TRUE(read);
  const RuleSet& set = *read;
  EXPECT_EQ(set.source.status, "industry practice");
  EXPECT_EQ(set.up, (Vec3d{0, 0, 1}));
  EXPECT_EQ(set.forward, (Vec3d{-1, 0, 0}));
  EXPECT_EQ(set.ground, Ground::lowest);
  EXPECT_DOUBLE_EQ(set.sag.value(), 0.1);
  ASSERT_EQ(set.rules.size(), 2U);
  const double limits[] = {4, 3.2};
  const Severity severities[] = {Severity::error, Severity::note};
  for (std::size_t i = 0; i < 2; ++i) {
    const Rule& rule = set.rules[i];
    EXPECT_EQ(rule.severity, severities[i]);
    EXPECT_EQ(rule.require.measure->name, "radius");
    EXPECT_EQ(rule.require.limit.kind, Limit::Kind::at_least);
    EXPECT_DOUBLE_EQ(rule.require.limit.low, limits[i]);
    ASSERT_EQ(rule.where.kind, Where::Kind::all);
    ASSERT_EQ(rule.where.children.size(), 2U);
    const Arguments& contact = rule.where.children[0].arguments;
    EXPECT_EQ(contact.text("probe"), "vertical cylinder");
    EXPECT_DOUBLE_EQ(contact.number("diameter"), 300.0);
    EXPECT_EQ(contact.text("motion"), "forward");
    const Arguments& height = rule.where.children[1].arguments;
    EXPECT_DOUBLE_EQ(height.number("from"), 0.0);
    EXPECT_DOUBLE_EQ(height.number("to"), 2000.0);
  }
}

TEST(Library, wall_packs_are_guidelines_that_name_the_source_of_every_number) {
  std::size_t packs = 0;
  for (const auto& file : files()) {
    if (!file.stem().string().starts_with("wall-")) continue;
    const auto set = read_rules(file, every_measure());
    ASSERT_TRUE(set) << to_string(set.error().at(0));
    EXPECT_EQ(set->source.status, "guideline");
    EXPECT_FALSE(set->source.address.empty());
    for (const Rule& rule : set->rules) {
      EXPECT_FALSE(rule.clause.empty()) << rule.id;
      EXPECT_EQ(rule.require.measure, &thickness_measure);
      EXPECT_EQ(rule.require.arguments.text("method"), "wall");
    }
    ++packs;
  }
  EXPECT_EQ(packs, 15U);
}

}  // namespace
}  // namespace gabarit
