#include "rules/read_rules.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checks/height.h"
#include "rules/region.h"
#include "tests/rules/language.h"
#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

using language::errors;
using language::messages;
using language::with_require;
using language::with_where;
using testing::ElementsAre;

constexpr const char* complete = R"(gabarit: 1                                   # version of this language
id: motorcycle-column
title: Motorcycle exterior, 300 mm vertical column
revision: "2026-11"
source: {document: "Inui & Umezu", edition: "2", address: "https://example.org/x", status: industry practice}
frame: {up: +y, forward: +x, ground: 12 cm}  # ground: lowest | a height such as 0 mm
sag: 0.05 mm
rules:
  - id: column-r4
    title: Größer als R4
    clause: 2.1
    severity: note
    where:
      all:
        - contact: {probe: vertical cylinder, diameter: 300 mm, motion: forward}
        - height: {from: 0 mm, to: 2 m}
        - any:
            - body: "tank*"
            - not: {facing: rear}
    require:
      radius: {at least: 0.4cm, method: sphere placement}
    ignore: {regions under: 2 cm2}
  - id: other
    require: {radius: {between: [1 mm, 1 in]}}
)";

TEST(ReadRules, a_complete_file_is_read_in_millimetres_and_radians) {
  const auto read = language::read(complete);
  ASSERT_TRUE(read) << errors(complete);
  const RuleSet& set = *read;
  EXPECT_EQ(set.file, "r.yaml");
  EXPECT_EQ(set.text, complete);
  EXPECT_EQ(set.sha256.size(), 64U);
  EXPECT_EQ(set.id, "motorcycle-column");
  EXPECT_EQ(set.revision, "2026-11");
  EXPECT_EQ(set.source.document, "Inui & Umezu");
  EXPECT_EQ(set.source.edition, "2");
  EXPECT_EQ(set.source.address, "https://example.org/x");
  EXPECT_EQ(set.source.status, "industry practice");
  EXPECT_EQ(set.up, (Vec3d{0, 1, 0}));
  EXPECT_EQ(set.forward, (Vec3d{1, 0, 0}));
  EXPECT_EQ(set.ground, Ground::height);
  EXPECT_DOUBLE_EQ(set.ground_height, 120.0);
  EXPECT_DOUBLE_EQ(set.sag.value(), 0.05);
  ASSERT_EQ(set.rules.size(), 2U);

  const Rule& rule = set.rules[0];
  EXPECT_EQ(rule.title, "Größer als R4");
  EXPECT_EQ(rule.clause, "2.1") << "text stays text";
  EXPECT_EQ(rule.severity, Severity::note);
  EXPECT_DOUBLE_EQ(rule.ignore_area, 200.0);
  EXPECT_EQ(rule.place.line, 9);
  EXPECT_EQ(rule.place.column, 5);
  EXPECT_EQ(rule.place.file, "r.yaml");
  EXPECT_EQ(rule.require.measure->name, "radius");
  EXPECT_EQ(rule.require.limit.kind, Limit::Kind::at_least);
  EXPECT_DOUBLE_EQ(rule.require.limit.low, 4.0);
  EXPECT_EQ(rule.require.limit_text, "at least 0.4cm");
  EXPECT_EQ(rule.require.arguments.text("method"), "sphere placement");
  EXPECT_DOUBLE_EQ(rule.require.arguments.number("window"), 2.0) << "the descriptor's default";

  ASSERT_EQ(rule.where.children.size(), 3U);
  EXPECT_DOUBLE_EQ(rule.where.children[0].arguments.number("diameter"), 300.0);
  EXPECT_EQ(rule.where.children[0].selector->variant, "vertical cylinder");
  EXPECT_EQ(rule.where.children[1].selector, &height_selector);
  EXPECT_DOUBLE_EQ(rule.where.children[1].arguments.number("to"), 2000.0);
  const Where& any = rule.where.children[2];
  EXPECT_EQ(any.kind, Where::Kind::any);
  EXPECT_EQ(any.children.at(0).arguments.text("name"), "tank*") << "the first parameter given alone";
  const Where& facing = any.children.at(1).children.at(0);
  EXPECT_EQ(any.children.at(1).kind, Where::Kind::none_of);
  EXPECT_EQ(facing.arguments.text("direction"), "rear");
  EXPECT_DOUBLE_EQ(facing.arguments.number("within"), std::numbers::pi / 2);
  EXPECT_EQ(facing.place.line, 19);
  EXPECT_EQ(facing.place.column, 21);

  const Limit& between = set.rules[1].require.limit;
  EXPECT_EQ(between.kind, Limit::Kind::between);
  EXPECT_DOUBLE_EQ(between.low, 1.0);
  EXPECT_DOUBLE_EQ(between.high, 25.4);
  EXPECT_EQ(set.rules[1].title, "other") << "a rule without a title is called by its id";
  EXPECT_TRUE(set.rules[1].where.children.empty());
}

TEST(ReadRules, other_line_ends_and_a_byte_order_mark_change_nothing) {
  std::string text = "\xEF\xBB\xBF";
  for (const char* c = complete; *c; ++c) text += *c == '\n' ? std::string("\r\n") : std::string(1, *c);
  ASSERT_EQ(errors(text), "fine");
  EXPECT_EQ(language::read(text)->rules[0].title, "Größer als R4");
  EXPECT_EQ(language::read(text)->rules[0].place.line, 9);
}

TEST(ReadRules, a_message_has_the_line_a_caret_and_what_would_be_right) {
  EXPECT_EQ(errors("gabarit: 1\nid: set\nrules:\n"
                   "  - {id: a, title: Größe → R4, require: {radius: {at lest: 4 mm}}}\n"),
            "r.yaml:4:46: error: `radius` has no limit\n"
            "    - {id: a, title: Größe → R4, require: {radius: {at lest: 4 mm}}}\n"
            "                                           ^~~~~~\n"
            "  give one of `at least`, `at most` and `between`\n"
            "r.yaml:4:55: error: unknown key `at lest` in `radius`\n"
            "    - {id: a, title: Größe → R4, require: {radius: {at lest: 4 mm}}}\n"
            "                                                    ^~~~~~~\n"
            "  did you mean `at least`? known are: `at least`, `at most`, `between`, `method`, `window`\n");
}

TEST(ReadRules, all_errors_of_a_file_come_at_once_in_its_order) {
  EXPECT_THAT(
      messages("gabarit: 1\nid: über\ntitel: x\nsag: 0.1\nsag: 1 mm\nrules:\n"
               "  - id: a\n    require: {radus: {at least: 4 mm}}\n"
               "  - id: A\n    where: {hight: 1 mm}\n"),
      ElementsAre("`über` can't be an id (an id has only letters, digits, `.`, `_` and `-`: it names files)",
                  "unknown key `titel` in a rule file (did you mean `title`? known are: `gabarit`, `id`, "
                  "`title`, `revision`, `source`, `frame`, `sag`, `rules`)",
                  "`0.1` has no unit (write `0.1 mm`; units of a length: mm, cm, m, in)",
                  "`sag` is given twice",
                  "unknown measure `radus` (did you mean `radius`? known are: `radius`, `angle`)",
                  "a rule needs `require`",
                  "the id `A` is already used by the rule at line 7 (ids name files: every rule has its "
                  "own, whatever the case of its letters)",
                  "unknown selector `hight` (did you mean `height`? known are: `contact`, `height`, `box`, "
                  "`facing`, `body`, `all`, `any`, `not`)"));
}

TEST(ReadRules, a_hundred_errors_are_enough) {
  std::string text = "gabarit: 1\nid: a\nrules: [{id: r, require: {radius: {at least: 1 mm}}}]\n";
  for (int i = 0; i < 1000; ++i) text += "key" + std::to_string(i) + ": 1\n";
  const auto all = messages(text);
  ASSERT_EQ(all.size(), 101U);
  EXPECT_EQ(all.back(), "900 more errors");
}

struct Case {
  const char* text;
  const char* message;
};

class WhereFaults : public testing::TestWithParam<Case> {};
TEST_P(WhereFaults, are_named) {
  EXPECT_THAT(messages(with_where(GetParam().text)), ElementsAre(GetParam().message));
}
INSTANTIATE_TEST_SUITE_P(
    ReadRules, WhereFaults,
    testing::Values(
        Case{"",
             "a selector is wanted here (such as `height: {from: 0 mm}`, or `all:`, `any:` or `not:` and "
             "selectors)"},
        Case{"{body: a, box: {from: [0 mm, 0 mm, 0 mm], to: [1 mm, 1 mm, 1 mm]}}",
             "`body` and `box` stand beside each other (put several selectors into a list under `all:` or "
             "`any:`)"},
        Case{"{all: []}", "`all` is a list of selectors (one selector a line, each after a dash)"},
        Case{"{any: {body: a}}", "`any` is a list of selectors (one selector a line, each after a dash)"},
        Case{"{not: [{body: a}]}",
             "a selector is wanted here (such as `height: {from: 0 mm}`, or `all:`, `any:` or "
             "`not:` and selectors)"},
        Case{"{contact: {probe: sphere, diameter: 300 mm}}",
             "unknown probe `sphere` (the only one known is `vertical cylinder`)"},
        Case{"{contact: {probe: vertical cylindre, diameter: 300 mm}}",
             "unknown probe `vertical cylindre` (did you mean `vertical cylinder`? the only one known is "
             "`vertical "
             "cylinder`)"},
        Case{"{contact: {diameter: 300 mm}}",
             "`contact` needs `probe` (the only one known is `vertical cylinder`)"},
        Case{"{contact: {probe: vertical cylinder, diameter: 300}}",
             "`300` has no unit (write `300 mm`; units of a length: mm, cm, m, in)"},
        Case{"{contact: {probe: vertical cylinder, diameter: 300 mm, motion: forwards}}",
             "unknown motion `forwards` (did you mean `forward`? known are: `any`, `forward`, `sweep`)"},
        Case{"{contact: {probe: vertical cylinder, diameter: 0 mm}}",
             "`0 mm` is out of range (`diameter` is at least 0.01 mm)"},
        Case{"{height: {}}", "`height` needs at least one of `from`, `to`"},
        Case{"{height: {from: 5 mm, to: 1 mm}}",
             "the range of `height` ends before it begins (`from` is not above `to`)"},
        Case{"{height: {from: 5 deg}}",
             "`5 deg` is an angle, a length is wanted (units of a length: mm, cm, m, in)"},
        Case{"{height: {from: [1 mm]}}", "`from` is one value"},
        Case{"{height: {from: }}", "`from` has no value"}, Case{"{height: }", "`height` has no value"},
        Case{"{height: {form: 5 mm, to: 9 mm}}",
             "unknown key `form` in `height` (did you mean `from`? known are: `from`, `to`)"},
        Case{"{box: {from: [0 mm, 0, 0 mm], to: [1 mm, 1 mm, 1 mm]}}",
             "`0` has no unit (write `0 mm`; units of a length: mm, cm, m, in)"},
        Case{"{box: {from: [0 mm, 0 mm], to: [1 mm, 1 mm, 1 mm]}}",
             "`[0 mm, 0 mm]` is not a point (three lengths are wanted, such as `[0 mm, 10 mm, 250 mm]`)"},
        Case{"{box: {from: [0 mm, 9 mm, 0 mm], to: [1 mm, 1 mm, 1 mm]}}",
             "the range of `box` ends before it begins (`from` is not above `to`)"},
        Case{"{facing: [0, 0, 0]}", "`[0, 0, 0]` points nowhere (a direction has a length of about 1)"},
        Case{"{facing: [0, 0, 1e300]}",
             "`[0, 0, 1e300]` points nowhere (a direction has a length of about 1)"},
        Case{"{facing: {direction: up, within: 200 deg}}",
             "`200 deg` is out of range (`within` is at most 180 deg)"},
        Case{
            "{facing: {within: 10 deg}}",
            "`facing` needs `direction` (A name, or a vector in the model's coordinates such as [0, 0, 1].)"},
        Case{"{body: \"\"}", "`name` is empty"}));

class RequireFaults : public testing::TestWithParam<Case> {};
TEST_P(RequireFaults, are_named) {
  EXPECT_THAT(messages(with_require(GetParam().text)), ElementsAre(GetParam().message));
}
INSTANTIATE_TEST_SUITE_P(
    ReadRules, RequireFaults,
    testing::Values(
        Case{"{}",
             "`require` is one measure with its limit (such as `radius: {at least: 4 mm}`; what else is "
             "required "
             "is another rule)"},
        Case{"{radius: 4 mm}", "`radius` has no limit (write `radius: {at least: …}`)"},
        Case{"{radius: {at least: 4 mm, at most: 5 mm}}",
             "`radius` has several limits (write `between: [smallest, greatest]`)"},
        Case{"{radius: {at least: 4 mm, between: [1 mm, 2 mm]}}",
             "`radius` has several limits (one limit a rule; write a second rule)"},
        Case{"{radius: {between: [4 mm, 3 mm]}}",
             "nothing is between `4 mm` and `3 mm` (the smaller limit comes first)"},
        Case{"{radius: {between: 3 mm}}",
             "`between` is a list of two limits (such as `between: [1 mm, 3 mm]`)"},
        Case{"{radius: {at least: 0 mm}}", "every value is at least `0 mm` (a limit is above 0)"},
        Case{"{radius: {at most: -1 mm}}", "no value is at most `-1 mm` (a limit is not negative)"},
        Case{"{radius: {at least: [4 mm]}}", "a limit is one value"},
        Case{"{radius: {at least: 4 mm2}}",
             "`4 mm2` is an area, a length is wanted (units of a length: mm, cm, m, in)"},
        Case{"{radius: {at least: 4 mm, method: turnin}}",
             "unknown method `turnin` (did you mean `turning`? known are: `turning`, `sphere placement`)"},
        Case{"{angle: {at least: 4 mm}}",
             "`4 mm` is a length, an angle is wanted (units of an angle: deg, rad)"}));

class FileFaults : public testing::TestWithParam<Case> {};
TEST_P(FileFaults, are_named) { EXPECT_THAT(messages(GetParam().text), ElementsAre(GetParam().message)); }
#define RULES "rules: [{id: r, require: {radius: {at least: 1 mm}}}]\n"
INSTANTIATE_TEST_SUITE_P(
    ReadRules, FileFaults,
    testing::Values(
        Case{"", "the file is empty (a rule file begins with `gabarit: 1`)"},
        Case{"# nothing\n", "the file is empty (a rule file begins with `gabarit: 1`)"},
        Case{"- a\n", "a rule file is a map of keys and values"},
        Case{"gabarit: 2\nfuture: 1\n",
             "unknown version `2` of the rule language (this program reads `gabarit: 1`)"},
        Case{"id: a\n" RULES, "a rule file needs `gabarit`"},
        Case{"gabarit: 1\n" RULES, "a rule file needs `id`"},
        Case{"gabarit: 1\nid: a\n", "a rule file needs `rules`"},
        Case{"gabarit: 1\nid: a\nrules: []\n",
             "`rules` is a list of rules (a file without a rule would check nothing)"},
        Case{"gabarit: 1\nid: a\nrules: [r]\n", "a rule is a map of keys and values"},
        Case{"gabarit: 1\nid: a\nid: b\n" RULES, "`id` is given twice"},
        Case{"gabarit: 1\nid: CON.x\n" RULES,
             "`CON.x` can't be an id (this id is a reserved name of some file systems)"},
        Case{"gabarit: 1\nid: ../x\n" RULES,
             "`../x` can't be an id (an id has only letters, digits, `.`, `_` and `-`: it names files)"},
        Case{"gabarit: 1\nid: .x\n" RULES,
             "`.x` can't be an id (an id does not begin with `.` or `-`: it names files)"},
        Case{"gabarit: 1\nid: a\ntitle: [x]\n" RULES, "`title` is a line of text"},
        Case{"gabarit: 1\nid: a\ntitle: |\n  x\n  y\n" RULES, "`title` is one line of at most 400 bytes"},
        Case{"gabarit: 1\nid: a\nframe: {up: -x}\n" RULES,
             "`up` and `forward` lie along the same axis (they are at right angles)"},
        Case{"gabarit: 1\nid: a\nframe: {up: z}\n" RULES,
             "`z` is not an axis (did you mean `+z`? known are: `+x`, `-x`, `+y`, `-y`, `+z`, `-z`)"},
        Case{"gabarit: 1\nid: a\nframe: {ground: bottom}\n" RULES,
             "unknown ground `bottom` (`lowest` (the lowest vertex) or a height such as `0 mm`)"},
        Case{"gabarit: 1\nid: a\nframe: {ground: 0}\n" RULES,
             "`0` has no unit (write `0 mm`; units of a length: mm, cm, m, in)"},
        Case{"gabarit: 1\nid: a\nsag: 0 mm\n" RULES,
             "a sag of `0 mm` would claim that the facets are the true surface (`sag` is the largest "
             "distance between "
             "them, above 0)"},
        Case{"gabarit: 1\nid: a\nsource: {status: x}\n" RULES, "`source` needs `document`"},
        Case{"gabarit: 1\nid: a\nrules: [{id: r, require: {radius: {at least: 1 mm}}, severity: erorr}]\n",
             "unknown severity `erorr` (did you mean `error`? known are: `error`, `warning`, `note`)"},
        Case{"gabarit: 1\nid: a\nrules: [{id: r, require: {radius: {at least: 1 mm}}, ignore: {regions "
             "under: 1 mm}}]\n",
             "`1 mm` is a length, an area is wanted (units of an area: mm2, cm2, m2, in2)"}));
#undef RULES

TEST(ReadRules, files_that_cannot_be_read_say_why) {
  const auto absent = read_rules("absent.yaml", language::catalogue());
  ASSERT_FALSE(absent);
  EXPECT_EQ(to_string(absent.error().at(0)),
            "absent.yaml: error: the rule file can't be read: No such file or directory\n");
  const auto folder = read_rules(std::filesystem::temp_directory_path(), language::catalogue());
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().at(0).message, "the rule file can't be read: it is a directory");
}

TEST(ReadRules, a_file_is_read_from_disk_and_keeps_its_name_without_the_folder) {
  const TemporaryFolder folder;
  put(folder / "some.yaml", complete);
  const auto read = read_rules(folder / "some.yaml", language::catalogue());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->file, "some.yaml");
  EXPECT_EQ(read->text, complete);
}

}  // namespace
}  // namespace gabarit
