#include <filesystem>

#include <gmock/gmock.h>

#include "tests/cli/run_gabarit.h"
#include "tests/model/mesh_files.h"
#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

using testing::HasSubstr;

// What `check` refuses before it measures anything: exit 2, a message, and the folder as it was.
class check_refuses : public testing::Test {
 protected:
  check_refuses() {
    put(folder_ / "part.stl", mesh_files::binary_stl(shapes::box({0, 0, 0}, {100, 20, 10})));
    put(folder_ / "bad.yaml", "gabarit: 1\nid: a\nrules: []\n");
    put(folder_ / "out/results.json", "old");
    put(folder_ / "out/mine.txt", "mine");
  }

  void expect(const std::vector<std::string>& arguments, const std::string& message) const {
    const auto before = tree(folder_.path());
    std::vector<std::string> all{"check", "--formats", "json,stl"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Ending run = run_gabarit(all, {.folder = folder_.path().string()});
    EXPECT_EQ(run.exit, 2) << message;
    EXPECT_EQ(run.out, "") << message;
    EXPECT_THAT(run.err, HasSubstr(message));
    EXPECT_EQ(tree(folder_.path()), before) << message;
    EXPECT_EQ(content(folder_ / "out/results.json"), "old");
  }
  TemporaryFolder folder_;
};

TEST_F(check_refuses, rule_files_with_errors_and_tells_all_of_them) {
  expect({"part.stl", "--rules", "bad.yaml", "--rules", "none.yaml", "--out", "out"},
         "bad.yaml:3:8: error: `rules` is a list of rules");
  expect({"part.stl", "--rules", "bad.yaml", "--rules", "none.yaml", "--out", "out"},
         "none.yaml: error: the rule file can't be read: No such file or directory");
  expect({"part.stl", "--rules", ".", "--out", "new/folder"}, "it is a directory");
}

TEST_F(check_refuses, a_place_for_the_outputs_that_cannot_be_a_folder) {
  expect({"part.stl", "--rules", "bad.yaml", "--out", "part.stl"}, "part.stl is not a folder");
  expect({"part.stl", "--rules", "bad.yaml", "--out", "part.stl/deeper"}, "part.stl is not a folder");
  expect({"part.stl", "--rules", "bad.yaml", "--out", "/dev/full"}, "/dev/full is not a folder");
  expect({"part.stl", "--rules", "bad.yaml", "--out", "/dev/full/out"}, "/dev/full is not a folder");
  expect({"part.stl", "--rules", "bad.yaml", "--out", ""}, "--out is empty");
}

TEST_F(check_refuses, a_rules_option_takes_one_file_so_that_the_model_may_come_last) {
  expect({"--rules", "bad.yaml", "--out", "out", "part.stl"},
         "bad.yaml:3:8: error: `rules` is a list of rules");
  expect({"--out", "out", "--rules", "bad.yaml", "part.stl"},
         "bad.yaml:3:8: error: `rules` is a list of rules");
}

}  // namespace
}  // namespace gabarit
