#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/cli/run_gabarit.h"
#include "tests/model/mesh_files.h"
#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

using Words = std::vector<std::string>;

const std::string header = "gabarit: 1\nid: test\ntitle: Test\nrules:\n";
const std::string sharp_rule =
    header + "  - {id: round, title: Round, require: {radius: {at least: 4 mm}}}\n";
const std::string nothing_rule =
    header +
    "  - {id: high, title: High, where: {height: {from: 500 mm, to: 600 mm}}, require: {radius: {at "
    "least: 4 mm}}}\n";

class check_command : public testing::Test {
 protected:
  check_command() {
    const shapes::Triangles box = shapes::box({0, 0, 0}, {100, 80, 60});
    put(folder_ / "part.stl", mesh_files::binary_stl(box));
    put(folder_ / "inside-out.stl", mesh_files::binary_stl(shapes::flipped(box)));
    put(folder_ / "round.yaml", sharp_rule);
    put(folder_ / "high.yaml", nothing_rule);
  }

  Ending check(const Words& words, RunOptions options = {}) const {
    Words all{"check", "--formats", "json,stl"};
    all.insert(all.end(), words.begin(), words.end());
    options.folder = folder_.path().string();
    return run_gabarit(all, options);
  }
  nlohmann::json results() const { return nlohmann::json::parse(content(folder_ / "out/results.json")); }

  TemporaryFolder folder_;
};

TEST_F(check_command, ends_with_1_when_a_rule_is_broken_and_writes_the_evidence) {
  const Ending run = check({"part.stl", "--rules", "round.yaml", "--out", "out"});
  EXPECT_EQ(run.exit, 1);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("round"));
  EXPECT_THAT(tree(folder_ / "out"), ElementsAre("results.json", "run.json", "violations", "violations.stl",
                                                 "violations/round.stl"));
  EXPECT_EQ(results()["verdict"], "fail");
  EXPECT_EQ(results()["totals"]["failed"], 1);
}

TEST_F(check_command, ends_with_0_when_nothing_is_selected) {
  const Ending run = check({"part.stl", "--rules", "high.yaml", "--out", "out"});
  EXPECT_EQ(run.exit, 0);
  EXPECT_EQ(results()["totals"]["not_applicable"], 1);
}

TEST_F(check_command, ends_with_3_when_something_is_undecided_and_as_told_by_fail_on) {
  const Words words{"inside-out.stl", "--rules", "round.yaml", "--out", "out"};
  EXPECT_EQ(check(words).exit, 3);
  EXPECT_EQ(results()["totals"]["undecided"], 1);
  const auto with = [&](const std::string& when) {
    Words more = words;
    more.insert(more.end(), {"--fail-on", when});
    return check(more).exit;
  };
  EXPECT_EQ(with("fail"), 3);
  EXPECT_EQ(with("undecided"), 1);
  EXPECT_EQ(with("never"), 0);
  EXPECT_EQ(check({"part.stl", "--rules", "round.yaml", "--out", "out", "--fail-on", "never"}).exit, 0);
}

TEST_F(check_command, quiet_prints_nothing_on_standard_output) {
  const Ending run = check({"part.stl", "--rules", "round.yaml", "--out", "out", "--quiet"});
  EXPECT_EQ(run.exit, 1);
  EXPECT_EQ(run.out + run.err, "");
}

TEST_F(check_command, gives_the_same_bytes_on_any_number_of_threads_and_in_every_run) {
  const auto bytes = [&](const std::string& threads) {
    EXPECT_EQ(
        check({"part.stl", "--rules", "round.yaml", "--out", "out", "--fields", "--threads", threads}).exit,
        1);
    std::string all;
    for (const std::string& name : tree(folder_ / "out")) {
      if (name == "run.json" || std::filesystem::is_directory(folder_ / "out" / name)) continue;
      all += name + '\n' + content(folder_ / "out" / name);
    }
    return all;
  };
  const std::string first = bytes("1");
  EXPECT_THAT(first, HasSubstr("fields/round.ply"));
  EXPECT_EQ(bytes("1"), first);
  EXPECT_EQ(bytes("2"), first);
}

TEST_F(check_command, only_runs_what_it_names_and_refuses_what_no_file_has) {
  const Words both{"part.stl", "--rules", "round.yaml", "--rules", "high.yaml", "--out", "out", "--only"};
  const auto only = [&](const std::string& rule) {
    Words words = both;
    words.push_back(rule);
    return check(words);
  };
  EXPECT_EQ(only("high").exit, 0);
  const auto before = tree(folder_.path());
  const Ending unknown = only("rund");
  EXPECT_EQ(unknown.exit, 2);
  EXPECT_THAT(unknown.err, HasSubstr("`rund`"));
  EXPECT_THAT(unknown.err, HasSubstr("`round`"));
  EXPECT_EQ(tree(folder_.path()), before);
}

TEST_F(check_command, refuses_two_files_with_a_rule_of_the_same_id) {
  put(folder_ / "again.yaml", sharp_rule);
  const Ending run = check({"part.stl", "--rules", "round.yaml", "--rules", "again.yaml", "--out", "out"});
  EXPECT_EQ(run.exit, 2);
  EXPECT_THAT(run.err, HasSubstr("again.yaml:5:"));
  EXPECT_THAT(run.err, HasSubstr("`round`"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(check_command, warns_of_a_model_in_metres_checked_with_millimetre_rules) {
  put(folder_ / "bike.stl", mesh_files::binary_stl(shapes::box({0, 0, 0}, {2.25, 0.75, 1.25})));
  const Ending run = check({"bike.stl", "--rules", "round.yaml", "--out", "out"});
  EXPECT_THAT(run.err,
              HasSubstr("implausible size: 2.25 mm long in mm as assumed; 2250 mm if the file is in metres"));
  EXPECT_EQ(check({"bike.stl", "--rules", "round.yaml", "--out", "out", "--units", "m"}).err, "");
  EXPECT_EQ(results()["model"]["unit"], "m");
  EXPECT_EQ(results()["model"]["box"]["max"], nlohmann::json({2250, 750, 1250}));
}

TEST_F(check_command, a_bad_model_leaves_the_folder_of_an_earlier_run_alone) {
  EXPECT_EQ(check({"part.stl", "--rules", "round.yaml", "--out", "out"}).exit, 1);
  const auto before = tree(folder_.path());
  const std::string results_before = content(folder_ / "out/results.json");
  EXPECT_EQ(check({"none.stl", "--rules", "round.yaml", "--out", "out"}).exit, 2);
  EXPECT_EQ(check({"round.yaml", "--rules", "round.yaml", "--out", "out"}).exit, 2);
  EXPECT_EQ(check({"none.stl", "--rules", "round.yaml", "--out", "new/deep"}).exit, 2);
  EXPECT_EQ(tree(folder_.path()), before);
  EXPECT_EQ(content(folder_ / "out/results.json"), results_before);
}

TEST_F(check_command, a_full_disk_leaves_the_folder_as_it_was) {
  put(folder_ / "out/results.json", "old");
  const auto before = tree(folder_.path());
  // Files may have 512 bytes: the JSON does not fit.
  const Ending run = check({"part.stl", "--rules", "round.yaml", "--out", "out"}, {.before = "ulimit -f 1"});
  EXPECT_EQ(run.exit, 2) << run.err;
  EXPECT_THAT(run.err, HasSubstr("cannot write: File too large"));
  EXPECT_EQ(tree(folder_.path()), before);
  EXPECT_EQ(content(folder_ / "out/results.json"), "old");
}

TEST_F(check_command, a_folder_that_cannot_be_written_is_named) {
  const Ending run = check({"part.stl", "--rules", "round.yaml", "--out", "/proc/gabarit-out"});
  EXPECT_EQ(run.exit, 2);
  EXPECT_THAT(run.err, HasSubstr("/proc/gabarit-out"));
  EXPECT_THAT(run.err, HasSubstr("cannot write"));
}

TEST_F(check_command, a_full_disk_behind_standard_output_does_not_change_the_verdict) {
  const Ending run = check({"part.stl", "--rules", "round.yaml", "--out", "out"}, {.out_to = "/dev/full"});
  EXPECT_EQ(run.exit, 1);
  EXPECT_THAT(run.err,
              HasSubstr("cannot write to standard output: No space left on device; the files are complete"));
  EXPECT_EQ(results()["verdict"], "fail");
}

TEST_F(check_command, names_in_the_wrong_encoding_still_give_good_json) {
  put(folder_ / "K\xE4se.stl", mesh_files::ascii_stl(shapes::box({0, 0, 0}, {100, 80, 60}), "\n", "K\xE4se"));
  EXPECT_EQ(check({"K\xE4se.stl", "--rules", "round.yaml", "--out", "out"}).exit, 1);
  EXPECT_EQ(results()["model"]["file"], "K\xEF\xBF\xBDse.stl");
}

TEST_F(check_command, a_killed_run_leaves_no_half_file_and_does_not_hinder_the_next) {
  put(folder_ / "ball.stl", mesh_files::binary_stl(shapes::sphere(3, 40, 60)));
  const Words words{"ball.stl", "--rules", "round.yaml", "--out", "out", "--fields", "--quiet"};
  const Ending whole = check(words);
  ASSERT_EQ(whole.exit, 1) << whole.err;
  const auto all = tree(folder_ / "out");
  const std::string right = content(folder_ / "out/results.json");
  for (int hundredths = 1; hundredths <= 30; hundredths += 2) {
    std::filesystem::remove_all(folder_ / "out");
    const Ending run =
        check(words, {.through = {"timeout", "-s", "KILL", fmt::format("{:.2f}", hundredths / 100.0)}});
    auto left = tree(folder_ / "out");
    std::erase_if(left, [](const std::string& name) { return name.starts_with(".gabarit-partial"); });
    // results.json comes last: where it is, everything is.
    if (left.contains("results.json")) {
      EXPECT_EQ(left, all);
      EXPECT_EQ(content(folder_ / "out/results.json"), right);
    } else {
      EXPECT_NE(run.exit, 1);
    }
    for (const std::string& name : left) EXPECT_THAT(name, Not(HasSubstr("partial")));
  }
  EXPECT_EQ(check(words).exit, 1);
  EXPECT_EQ(tree(folder_ / "out"), all);
}

TEST_F(check_command, a_measure_writes_its_field_and_refuses_what_it_does_not_know) {
  const auto measure = [&](Words words) {
    words.insert(words.begin(), {"measure", "part.stl", "radius", "--out"});
    return run_gabarit(words, {.folder = folder_.path().string()});
  };
  const Ending run = measure({"field.ply"});
  EXPECT_EQ(run.exit, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, StartsWith("radius: "));
  EXPECT_THAT(content(folder_ / "field.ply"), StartsWith("ply\nformat binary_little_endian 1.0\n"));
  const auto before = tree(folder_.path());
  const auto refused = [&](const Words& words, const std::string& message) {
    const Ending ending = measure(words);
    EXPECT_EQ(ending.exit, 2) << message;
    EXPECT_THAT(ending.err, HasSubstr(message));
    EXPECT_EQ(tree(folder_.path()), before);
  };
  refused({"f.ply", "--metod", "turning"}, "`radius` has no option `--metod`: did you mean `--method`?");
  refused({"f.ply", "--method", "turnin"}, "did you mean `turning`?");
  refused({"f.ply", "--method"}, "--method needs a value");
  refused({"none/f.ply"}, "there is no folder");
  refused({"."}, "is a folder");
  refused({""}, "--out is empty");
  refused({"/dev/full/f.ply"}, "there is no folder");
}

}  // namespace
}  // namespace gabarit
