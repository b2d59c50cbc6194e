#include "report/installation.h"

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

namespace fs = std::filesystem;

// Two installations, of which the program in the first one runs.
class Installation : public testing::Test {
 protected:
  Installation() {
    for (const char* const one : {"one", "two"}) {
      fs::create_directories(folder_ / one / "share/gabarit");
      put(folder_ / one / "bin/gabarit", "a program");
      fs::permissions(folder_ / one / "bin/gabarit", fs::perms::owner_all);
    }
    fs::create_symlink(folder_ / "one/bin/gabarit", folder_ / "link");
  }
  fs::path share(const char* one) const { return fs::canonical(folder_ / one / "share/gabarit"); }
  std::string bin(const char* one) const { return (folder_ / one / "bin").string(); }

  TemporaryFolder folder_;
  const fs::path unreadable_ = folder_ / "no/proc/self/exe";
};

TEST_F(Installation, is_where_the_link_of_the_system_leads_whatever_the_program_was_called) {
  EXPECT_EQ(installed_files({folder_ / "link", bin("two") + "/gabarit", bin("two"), folder_ / "two"}),
            share("one"));
}

TEST_F(Installation, of_a_program_in_a_build_folder_is_not_another_one) {
  fs::remove_all(folder_ / "one/share");
  EXPECT_EQ(installed_files({folder_ / "link", bin("two") + "/gabarit", bin("two"), folder_ / "two"}), "");
}

TEST_F(Installation, without_that_link_is_where_the_program_was_called) {
  EXPECT_EQ(installed_files({unreadable_, bin("one") + "/gabarit", bin("two"), folder_ / "two"}),
            share("one"));
  EXPECT_EQ(installed_files({unreadable_, folder_ / "link", bin("two"), folder_ / "two"}), share("one"));
}

TEST_F(Installation, of_a_word_without_a_folder_is_where_the_search_finds_it_first) {
  const std::string search = "/nowhere::" + bin("one") + ":" + bin("two");
  EXPECT_EQ(installed_files({unreadable_, "gabarit", search, {}}), share("one"));
}

TEST_F(Installation, of_a_file_that_is_no_program_is_not_found) {
  fs::permissions(folder_ / "one/bin/gabarit", fs::perms::owner_read);
  EXPECT_EQ(installed_files({unreadable_, "gabarit", bin("one") + ":" + bin("two"), {}}), share("two"));
  EXPECT_EQ(installed_files({unreadable_, bin("one") + "/gabarit", bin("two"), {}}), "");
}

TEST_F(Installation, is_where_the_build_was_to_go_when_nothing_else_tells) {
  for (const char* const called : {"", "another name", "/not/here/gabarit"})
    EXPECT_EQ(installed_files({unreadable_, called, bin("one"), folder_ / "two"}),
              folder_ / "two/share/gabarit");
}

TEST_F(Installation, that_nothing_tells_is_empty) {
  EXPECT_EQ(installed_files({unreadable_, "", "", {}}), "");
  EXPECT_EQ(installed_files({unreadable_, "gabarit", "", folder_ / "three"}), "");
}

}  // namespace
}  // namespace gabarit
