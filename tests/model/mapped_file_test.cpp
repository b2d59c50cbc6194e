#include "model/mapped_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

using testing::HasSubstr;

std::string reason(const Result<MappedFile>& file) { return file ? "" : to_string(file.error()[0]); }

TEST(mapped_file, gives_the_bytes_of_the_file) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n", 4);
  put(folder / "file", bytes);
  const Result<MappedFile> file = MappedFile::open(folder / "file");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->text(), bytes);
  EXPECT_EQ(file->bytes().size(), 4U);
}

TEST(mapped_file, an_empty_file_has_no_bytes) {
  const TemporaryFolder folder;
  put(folder / "file", "");
  const Result<MappedFile> file = MappedFile::open(folder / "file");
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->text().empty());
}

TEST(mapped_file, stays_readable_when_moved_and_when_the_name_goes) {
  const TemporaryFolder folder;
  put(folder / "file", "content");
  Result<MappedFile> file = MappedFile::open(folder / "file");
  ASSERT_TRUE(file);
  std::filesystem::remove(folder / "file");
  const MappedFile moved = std::move(*file);
  EXPECT_EQ(moved.text(), "content");
}

TEST(mapped_file, what_cannot_be_mapped_is_named_with_the_systems_reason) {
  const TemporaryFolder folder;
  EXPECT_THAT(reason(MappedFile::open(folder / "none")),
              HasSubstr("none: error: cannot be opened: No such file"));
  EXPECT_THAT(reason(MappedFile::open(folder.path())), HasSubstr("is a folder; give a model file"));
  EXPECT_THAT(reason(MappedFile::open("/dev/zero")), HasSubstr("is not a regular file"));
  // A pipe that nobody writes to must not be waited for.
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(reason(MappedFile::open(folder / "pipe")), HasSubstr("is not a regular file"));
  std::filesystem::create_symlink(folder / "loop", folder / "loop");
  EXPECT_THAT(reason(MappedFile::open(folder / "loop")), HasSubstr("cannot be opened: Too many levels"));
}

}  // namespace
}  // namespace gabarit
