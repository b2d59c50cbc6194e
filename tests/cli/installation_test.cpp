#include <filesystem>

#include <gmock/gmock.h>

#include "tests/cli/run_gabarit.h"
#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

using testing::HasSubstr;

const std::string pack =
    "gabarit: 1\nid: pack\ntitle: Pack\nrules:\n"
    "  - {id: round, title: Round, require: {radius: {at least: 4 mm}}}\n";

// A copy of the program where a package or a bundle would put it.
class InstalledProgram : public testing::Test {
 protected:
  InstalledProgram() {
    put(folder_ / "share/gabarit/rules/pack.yaml", pack);
    put(folder_ / "elsewhere/other.yaml", "gabarit: 1\n");
    std::filesystem::create_directory(folder_ / "bin");
    std::filesystem::copy_file(GABARIT_PROGRAM, folder_ / "bin/gabarit");
  }
  Ending validate(const std::string& name) const {
    return run_gabarit({"validate", name}, {.program = (folder_ / "bin/gabarit").string(),
                                            .folder = (folder_ / "elsewhere").string()});
  }
  TemporaryFolder folder_;
};

TEST_F(InstalledProgram, finds_the_packs_that_came_with_it_by_name) {
  for (const char* const name : {"pack", "pack.yaml"}) {
    const Ending run = validate(name);
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("fine: pack, 1 rules"));
  }
}

TEST_F(InstalledProgram, takes_a_file_of_the_user_before_a_pack_of_the_same_name) {
  put(folder_ / "elsewhere/pack", "not rules");
  EXPECT_EQ(validate("pack").exit, 2);
}

TEST_F(InstalledProgram, says_what_the_user_wrote_when_there_is_neither) {
  const Ending run = validate("unknown");
  EXPECT_EQ(run.exit, 2);
  EXPECT_THAT(run.err, HasSubstr("unknown: error: there is no such file, and no rule pack of that name"));
  EXPECT_THAT(run.err, HasSubstr("are: pack\n"));
}

TEST_F(InstalledProgram, says_that_its_packs_were_not_found) {
  std::filesystem::remove_all(folder_ / "share");
  const Ending run = validate("pack");
  EXPECT_EQ(run.exit, 2);
  EXPECT_THAT(run.err, HasSubstr("the rule packs of the program were not found"));
}

TEST_F(InstalledProgram, looks_for_no_pack_where_a_folder_is_named) { EXPECT_EQ(validate("./pack").exit, 2); }

}  // namespace
}  // namespace gabarit
