#include <filesystem>

#include <gmock/gmock.h>

#include "model/sha256.h"
#include "tests/cli/run_gabarit.h"
#include "tests/model/mesh_files.h"
#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class info_command : public testing::Test {
 protected:
  Ending info(const std::string& name, const std::string& bytes,
              const std::vector<std::string>& more = {}) const {
    put(folder_ / name, bytes);
    return info_of(name, more);
  }
  Ending info_of(const std::string& name, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"info", name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gabarit(arguments, {.folder = folder_.path().string()});
  }
  TemporaryFolder folder_;
};

const shapes::Triangles box = shapes::box({0, 0, 0}, {100, 20, 10});

TEST_F(info_command, says_what_the_file_holds) {
  const std::string bytes = mesh_files::binary_stl(box);
  const Ending run = info("part.stl", bytes);
  EXPECT_EQ(run.exit, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(run.out,
            "file         part.stl\nsha256       " + sha256(bytes) +
                "\nformat       binary STL\nunit         mm (assumed)\nsag          not declared\n"
                "facets       12\nvertices     8\nbodies       1\n"
                "box          (0, 0, 0) to (100, 20, 10) mm\nsize         100 × 20 × 10 mm\n"
                "watertight   yes\ndefects      0 facets not finite, 0 degenerate, 0 duplicate; edges: "
                "0 open, 0 non-manifold, 0 misoriented\n");
}

TEST_F(info_command, gives_the_same_bytes_on_one_thread_and_on_two) {
  const std::string bytes = mesh_files::obj(shapes::gridded_box({0, 0, 0}, {100, 20, 10}, 1));
  EXPECT_EQ(info("part.obj", bytes, {"--threads", "1"}).out, info("part.obj", bytes, {"--threads", "2"}).out);
}

TEST_F(info_command, units_scale_the_model_and_are_said) {
  const Ending run = info("part.ply", mesh_files::ply(box), {"--units", "in", "--sag", "0.1in"});
  EXPECT_EQ(run.exit, 0);
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("unit         in (declared)"), HasSubstr("size         2540 × 508 × 254 mm"),
                    HasSubstr("sag          2.54 mm")));
}

TEST_F(info_command, warns_of_a_model_in_metres_and_names_both_sizes) {
  const Ending run = info("bike.off", mesh_files::off(shapes::box({0, 0, 0}, {2.2, 0.8, 1.2})));
  EXPECT_EQ(run.exit, 0);
  EXPECT_THAT(run.err,
              HasSubstr("bike.off: warning: implausible size: 2.2 mm long in mm as assumed; 2200 mm if the "
                        "file is in metres: give --units m"));
  const Ending right = info_of("bike.off", {"--units", "m"});
  EXPECT_EQ(right.err, "");
  EXPECT_THAT(right.out, HasSubstr("size         2200 × 800 × 1200 mm"));
}

TEST_F(info_command, counts_every_kind_of_defect) {
  // The first and the last facet of the box share an edge.
  shapes::Triangles broken = box;
  broken.pop_back();
  broken.push_back(broken[0]);
  broken.push_back({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}});
  const Ending run = info("broken.stl", mesh_files::ascii_stl(broken));
  EXPECT_EQ(run.exit, 0);
  EXPECT_THAT(run.out, HasSubstr("watertight   no\ndefects      0 facets not finite, 1 degenerate, 1 "
                                 "duplicate; edges: 2 open, 2 non-manifold, 1 misoriented"));
}

TEST_F(info_command, what_is_no_model_file_ends_with_2_and_the_reason) {
  std::filesystem::create_directory(folder_ / "folder.stl");
  const auto expect = [](const Ending& run, const std::string& message) {
    EXPECT_EQ(run.exit, 2) << message;
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, HasSubstr(message));
  };
  expect(info_of("none.stl"), "none.stl: error: cannot be opened: No such file or directory");
  expect(info_of("folder.stl"), "folder.stl: error: is a folder; give a model file");
  expect(info_of("/dev/null"), "/dev/null: error: is not a regular file");
  expect(info("empty.stl", ""), "empty.stl: error: is empty");
  expect(info("part.step", "ISO-10303-21;\n"), GABARIT_READS_STEP
                                                   ? "part.step: error: has no DATA section"
                                                   : "part.step: error: STEP and IGES files cannot be read");
  expect(info("part.3mf", std::string("PK\3\4")), "'.3mf' files cannot be read by this version");
  expect(info("part.gltf", "{}"), std::string("it reads .stl, .obj, .ply") +
                                      (GABARIT_READS_STEP ? ", .off, .step and .iges" : " and .off") +
                                      ": export the model as one of them");
  expect(info("part.stl.gz", "\x1F\x8B"), "unpack it first");
  expect(info("part", "hello"), "its name has no ending");
  expect(info_of(std::string(300, 'a') + ".stl"), "cannot be opened: File name too long");
}

TEST_F(info_command, names_and_messages_do_not_steer_the_terminal) {
  const Ending run = info("part.stl", "solid \x1B]0;owned\x07\nfacet normal \x1B[2J");
  EXPECT_EQ(run.exit, 2);
  EXPECT_EQ(run.err.find('\x1B'), std::string::npos);
  const Ending odd = info("K\xE4se\x1B[31m.stl", mesh_files::binary_stl(box));
  EXPECT_EQ(odd.exit, 0);
  EXPECT_THAT(odd.out, HasSubstr("file         K\xEF\xBF\xBDse [31m.stl"));
}

TEST_F(info_command, a_sparse_file_of_5_gb_is_refused_with_little_memory) {
  put(folder_ / "sparse.stl", "");
  std::error_code no_room;
  std::filesystem::resize_file(folder_ / "sparse.stl", std::uintmax_t{5} << 30U, no_room);
  if (no_room) GTEST_SKIP() << "no sparse files here";
  const Ending run = info_of("sparse.stl");
  EXPECT_EQ(run.exit, 2);
  EXPECT_THAT(run.err, HasSubstr("the header announces 0 facets, the file holds 107374180"));
  EXPECT_LT(run.peak_memory, 400L << 20);
}

TEST_F(info_command, a_full_disk_behind_standard_output_is_said) {
  put(folder_ / "part.stl", mesh_files::binary_stl(box));
  const Ending run = run_gabarit({"info", (folder_ / "part.stl").string()}, {.out_to = "/dev/full"});
  EXPECT_EQ(run.exit, 2);
  EXPECT_THAT(run.err, HasSubstr("cannot write to standard output: No space left on device"));
}

TEST_F(info_command, draws_no_progress_into_a_file) {
  const Ending run =
      run_gabarit({"info", (folder_ / "part.stl").string()}, {.through = {"env", "TERM=xterm"}});
  EXPECT_EQ(run.err.find('\r'), std::string::npos);
}

}  // namespace
}  // namespace gabarit
