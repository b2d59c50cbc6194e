#include "report/write.h"

#include <gmock/gmock.h>

#include "report/output_set.h"
#include "tests/report/sample_report.h"
#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

WriteOptions options(std::vector<Format> formats, bool fields = false) {
  WriteOptions o;
  o.formats = std::move(formats);
  o.fields = fields;
  return o;
}

TEST(write, puts_the_outputs_of_the_contract_into_a_new_folder) {
  const TemporaryFolder folder;
  const SampleReport sample;
  const auto written = write(sample.report(), folder / "a/b", options({Format::stl, Format::json}, true));
  ASSERT_TRUE(written.has_value());
  EXPECT_THAT(tree(folder / "a/b"), ElementsAre("fields", "fields/absent.ply", "fields/failing.ply",
                                                "fields/passing.ply", "fields/undecided.ply", "results.json",
                                                "violations", "violations.stl", "violations/failing.stl"));
}

TEST(write, removes_what_an_earlier_run_left_and_nothing_else) {
  const TemporaryFolder folder;
  SampleReport sample;
  ASSERT_TRUE(
      write(sample.report(), folder.path(), options({Format::json, Format::stl, Format::junit}, true)));
  put(folder / "violations/mine.stl", "solid mine");
  put(folder / "notes.txt", "mine");
  sample.outcome.results.erase(sample.outcome.results.begin() + 1);  // nothing fails any more
  ASSERT_TRUE(write(sample.report(), folder.path(), options({Format::json})));
  EXPECT_THAT(tree(folder.path()),
              ElementsAre("notes.txt", "results.json", "violations", "violations/mine.stl"));
}

TEST(write, leaves_a_strangers_report_alone) {
  const TemporaryFolder folder;
  put(folder / "report.pdf", "mine");
  ASSERT_TRUE(write(SampleReport().report(), folder.path(), options({Format::json})));
  EXPECT_EQ(content(folder / "report.pdf"), "mine");
}

TEST(write, says_which_file_is_in_the_way_and_changes_nothing) {
  const TemporaryFolder folder;
  put(folder / "results.json/inside", "mine");
  const auto before = tree(folder.path());
  const auto written = write(SampleReport().report(), folder.path(), options({Format::json, Format::stl}));
  ASSERT_FALSE(written.has_value());
  EXPECT_THAT(to_string(written.error()[0]), HasSubstr("cannot write: Is a directory"));
  EXPECT_EQ(tree(folder.path()), before);
}

TEST(write, a_file_in_place_of_the_folder_is_an_error) {
  const TemporaryFolder folder;
  put(folder / "file", "mine");
  EXPECT_FALSE(write(SampleReport().report(), folder / "file/out", options({Format::json})).has_value());
  EXPECT_FALSE(write(SampleReport().report(), folder / "file", options({Format::json})).has_value());
  EXPECT_EQ(content(folder / "file"), "mine");
}

TEST(output_set, without_commit_leaves_the_folder_as_it_was) {
  const TemporaryFolder folder;
  put(folder / "results.json", "old");
  {
    OutputSet set(folder.path());
    set.add("results.json", [](OutputFile& file) { file.write(std::string("new")); });
  }
  EXPECT_EQ(content(folder / "results.json"), "old");
  { OutputSet set(folder / "new/folder"); }
  EXPECT_THAT(tree(folder.path()), ElementsAre("results.json"));
}

TEST(output_set, a_writer_that_fails_leaves_nothing) {
  const TemporaryFolder folder;
  EXPECT_THROW(
      {
        OutputSet set(folder / "out");
        set.add("one", [](OutputFile& file) { file.write(std::string("1")); });
        set.add("two", [](OutputFile&) { throw std::bad_alloc(); });
      },
      std::bad_alloc);
  EXPECT_THAT(tree(folder.path()), IsEmpty());
}

TEST(output_set, refuses_a_folder_that_another_run_writes_to) {
  const TemporaryFolder folder;
  OutputSet first(folder.path());
  first.add("one", [](OutputFile& file) { file.write(std::string("1")); });
  EXPECT_THROW(OutputSet second(folder.path()), std::filesystem::filesystem_error);
  first.commit();
  EXPECT_THAT(tree(folder.path()), Contains("one"));
}

TEST(output_set, clears_what_a_killed_run_left) {
  const TemporaryFolder folder;
  put(folder / ".gabarit-partial/half.pdf", "half");
  {
    OutputSet set(folder.path());
    set.add("one", [](OutputFile& file) { file.write(std::string("1")); });
    set.commit();
  }
  EXPECT_THAT(tree(folder.path()), ElementsAre("one"));
}

TEST(output_file, a_full_disk_is_said_and_the_old_file_stays) {
  const TemporaryFolder folder;
  put(folder / "out", "old");
  std::filesystem::create_symlink("/dev/full", folder / "out.partial");
  try {
    OutputFile file(folder / "out");
    file.write(std::string("new"));
    file.commit();
    ADD_FAILURE() << "a full disk took a file";
  } catch (const std::filesystem::filesystem_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_space_on_device);
  }
  EXPECT_EQ(content(folder / "out"), "old");
  EXPECT_THAT(tree(folder.path()), ElementsAre("out"));
}

}  // namespace
}  // namespace gabarit
