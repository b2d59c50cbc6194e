#include <sstream>

#include <gmock/gmock.h>

#include "tests/cli/run_gabarit.h"

namespace gabarit {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

const std::vector<std::string> commands{"check", "measure", "explain", "validate", "info", "devices"};

// Characters, not bytes.
std::size_t width(const std::string& line) {
  std::size_t n = 0;
  for (const char c : line) n += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  return n;
}

void expect_fits_a_screen(const std::string& text) {
  std::istringstream lines(text);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(width(line), 80U) << line;
  EXPECT_LE(count, 24U) << text;
}

TEST(help, of_every_command_fits_a_screen_of_24_lines_and_80_columns) {
  for (const std::string& command : commands) {
    const Ending run = run_gabarit({command, "--help"});
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err, "");
    expect_fits_a_screen(run.out);
  }
  const Ending run = run_gabarit({"--help"});
  EXPECT_EQ(run.exit, 0);
  expect_fits_a_screen(run.out);
  for (const std::string& command : commands) EXPECT_THAT(run.out, HasSubstr("\n  " + command + " "));
  EXPECT_THAT(run.out, HasSubstr("Exit codes: 0 clean, 1 violation, 2 bad input"));
}

TEST(help, version_is_one_line) {
  const Ending run = run_gabarit({"--version"});
  EXPECT_EQ(run.exit, 0);
  EXPECT_THAT(run.out, MatchesRegex("gabarit [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

struct Usage {
  std::vector<std::string> arguments;
  std::string message;
};

TEST(usage, a_mistake_ends_with_2_and_names_what_was_probably_meant) {
  const std::vector<Usage> mistakes{
      {{}, "name a command: check, measure, explain, validate, info, devices"},
      {{"chek"}, "there is no command `chek`; did you mean `check`?"},
      {{"zzz"}, "there is no command `zzz`\nThe commands are: check"},
      {{"--verson"}, "`gabarit` has no option `--verson`; did you mean `--version`?"},
      {{"info", "--unit", "m", "a.stl"}, "`info` has no option `--unit`; did you mean `--units`?"},
      {{"check", "a.stl", "--rule=b", "--out", "c"},
       "`check` has no option `--rule`; did you mean `--rules`?"},
      {{"check", "a.stl", "--rules", "b"}, "--out is required"},
      {{"check", "a.stl", "--out", "c"}, "--rules is required"},
      {{"info"}, "MODEL is required"},
      {{"info", "--units", "km", "a.stl"}, "--units: km not in {mm,cm,m,in}"},
      {{"info", "--threads", "0", "a.stl"}, "--threads: Value 0 not in range 1 to 4096"},
      {{"info", "--sag", "0.1", "a.stl"}, "--sag: `0.1` has no unit"},
      {{"info", "--sag", "-1 mm", "a.stl"}, "--sag must be more than 0, not -1 mm"},
      {{"info", "--facet-size", "0 mm", "a.step"}, "--facet-size must be more than 0, not 0 mm"},
      {{"info", "--sag", "2 deg", "a.stl"}, "`2 deg` is an angle, a length is wanted"},
      {{"check", "a.stl", "--rules", "b", "--out", ""}, "--out is empty"},
      {{"check", "a.stl", "--rules", "b", "--out", "c", "--formats", "jsn"},
       "no format is called `jsn`: did you mean `json`?"},
      {{"check", "a.stl", "--rules", "b", "--out", "c", "--formats", ""}, "name at least one format"},
      {{"check", "a.stl", "--rules", "b", "--out", "c", "--fail-on", "warning"}, "--fail-on: warning not in"},
      {{"check", "a.stl", "--rules", "b", "--out", "c", "--device", "gpu"}, "--device: gpu not in"},
      {{"measure", "a.stl", "thikness", "--out", "c.ply"}, "no measure is called `thikness`"},
  };
  for (const Usage& usage : mistakes) {
    const Ending run = run_gabarit(usage.arguments);
    EXPECT_EQ(run.exit, 2) << usage.message;
    EXPECT_EQ(run.out, "") << usage.message;
    EXPECT_THAT(run.err, HasSubstr("gabarit: error: "));
    EXPECT_THAT(run.err, HasSubstr(usage.message));
    EXPECT_THAT(run.err, HasSubstr("See gabarit --help"));
  }
}

}  // namespace
}  // namespace gabarit
