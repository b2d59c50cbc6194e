#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "rules/read_rules.h"
#include "tests/cli/run_gabarit.h"
#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

Ending validate(const std::string& text) {
  const TemporaryFolder folder;
  put(folder / "rules.yaml", text);
  return run_gabarit({"validate", "rules.yaml"}, {.folder = folder.path().string()});
}

// A megabyte of text, the largest file that is read, as a tree; half of it is what the sanitizers keep.
constexpr long bounded_memory = 1L << 30;

TEST(validate_command, agrees_with_the_reader_on_every_file_of_the_library) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(GABARIT_SOURCE_DIR "/rules/library")) {
    if (entry.path().extension() != ".yaml") continue;
    ++files;
    const bool fine = read_rules(entry.path()).has_value();
    const Ending run = run_gabarit({"validate", entry.path().string()});
    EXPECT_EQ(run.exit, fine ? 0 : 2) << run.err;
    EXPECT_EQ(run.out.find(": fine: ") != std::string::npos, fine);
    EXPECT_EQ(run.err.empty(), fine);
  }
  EXPECT_GE(files, 1U);
}

TEST(validate_command, reports_several_errors_at_once_with_carets) {
  const Ending run = validate(
      "gabarit: 1\nid: a\ntitel: x\nrules:\n  - id: r\n    severity: eror\n    where: {contcat: {probe: "
      "sphere}}\n"
      "    require: {radus: {at least: 4}}\n");
  EXPECT_EQ(run.exit, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr("rules.yaml:3:1: error: "));
  EXPECT_THAT(run.err, HasSubstr("rules.yaml:6:15: error: unknown severity `eror`\n"
                                 "      severity: eror\n"
                                 "                ^~~~\n"
                                 "  did you mean `error`?"));
  EXPECT_THAT(run.err, HasSubstr("rules.yaml:7:13: error: "));
  EXPECT_THAT(run.err, HasSubstr("did you mean `contact`?"));
  EXPECT_THAT(run.err, HasSubstr("rules.yaml:8:15: error: "));
}

TEST(validate_command, an_unknown_probe_gets_the_nearest_one) {
  const Ending run = validate(
      "gabarit: 1\nid: a\nrules:\n  - id: r\n    where: {contact: {probe: vertical cilinder, diameter: 300 "
      "mm}}\n"
      "    require: {radius: {at least: 4 mm}}\n");
  EXPECT_EQ(run.exit, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("rules.yaml:5:30: error: "), HasSubstr("`vertical cilinder`"),
                             HasSubstr("`vertical cylinder`"), HasSubstr("^~~~~~~~~~~~~~~~~")));
}

TEST(validate_command, an_explosion_of_aliases_is_refused_at_once) {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 30; ++i)
    bomb += fmt::format("a{0}: &a{0} [*a{1}, *a{1}, *a{1}, *a{1}, *a{1}, *a{1}, *a{1}]\n", i, i - 1);
  const Ending run = validate(bomb);
  EXPECT_EQ(run.exit, 2);
  EXPECT_THAT(run.err, HasSubstr("rules.yaml:1:5: error: anchors and aliases"));
  EXPECT_LT(run.peak_memory, bounded_memory);
}

TEST(validate_command, deep_nesting_is_refused_with_little_memory) {
  for (const std::string open : {"[", "{a: ", "- ", "? "}) {
    std::string bomb;
    while (bomb.size() < 900'000) bomb += open;
    const bool block = open == "- " || open == "? ";
    const Ending run = validate(fmt::format("rules: {}{}", block ? "\n" : "", bomb));
    EXPECT_EQ(run.exit, 2) << open << run.err.substr(0, 300);
    EXPECT_THAT(run.err, HasSubstr("rules.yaml:")) << open;
    EXPECT_LT(run.err.size(), 4'000U) << open;
    EXPECT_LT(run.peak_memory, bounded_memory) << open;
  }
}

TEST(validate_command, long_keys_scalars_and_many_rules_are_bounded) {
  std::string rules = "gabarit: 1\nid: a\nrules:\n";
  while (rules.size() < 1'000'000) rules += "  - {id: a}\n";
  const auto many = [](char c) { return std::string(1'000'000, c); };
  const std::vector<std::string> bombs{rules,
                                       fmt::format("a: {}", many('x')),
                                       many('k') + ": 1",
                                       fmt::format("a: \"{}", many(' ')),
                                       fmt::format("a: |\n{}", many(' ')),
                                       many('#'),
                                       many('\n'),
                                       fmt::format("%{}", many('T'))};
  for (const std::string& bomb : bombs) {
    const Ending run = validate(bomb);
    EXPECT_EQ(run.exit, 2) << bomb.substr(0, 20);
    EXPECT_LT(run.err.size(), 100'000U) << bomb.substr(0, 20);
    EXPECT_LT(run.peak_memory, bounded_memory) << bomb.substr(0, 20);
  }
}

TEST(validate_command, what_is_no_rule_file_is_named_with_the_reason) {
  EXPECT_THAT(validate("").err, HasSubstr("rules.yaml: error: the file is empty"));
  EXPECT_THAT(validate(std::string("\xFF\xFEg\0a\0", 6)).err,
              HasSubstr("rules.yaml:1:1: error: the byte 0xFF"));
  EXPECT_THAT(validate("gabarit: 1\nid: K\xE4se\n").err,
              HasSubstr("rules.yaml:2:6: error: the byte 0xE4 is not UTF-8"));
  EXPECT_THAT(validate(std::string("gabarit: 1\0", 11)).err, HasSubstr("a control character (0x00)"));
  EXPECT_THAT(validate(std::string(2'000'000, ' ')).err, HasSubstr("larger than 1 MiB"));
  const TemporaryFolder folder;
  const Ending missing = run_gabarit({"validate", (folder / "none.yaml").string(), folder.path().string()});
  EXPECT_EQ(missing.exit, 2);
  EXPECT_THAT(missing.err,
              HasSubstr("none.yaml: error: the rule file can't be read: No such file or directory"));
  EXPECT_THAT(missing.err, EndsWith("the rule file can't be read: it is a directory\n"));
}

TEST(validate_command, a_good_file_is_told_on_standard_output_even_beside_a_bad_one) {
  const TemporaryFolder folder;
  put(folder / "bad.yaml", "gabarit: 2\n");
  const Ending run = run_gabarit({"validate", "bad.yaml", "none.yaml"}, {.folder = folder.path().string()});
  EXPECT_EQ(run.exit, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("bad.yaml:1:10: error: unknown version `2`"), HasSubstr("none.yaml")));
}

}  // namespace
}  // namespace gabarit
