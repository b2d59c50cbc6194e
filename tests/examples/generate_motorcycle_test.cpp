// The program as a user runs it.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

#include "examples/motorcycle/motorcycle.h"
#include "model/load.h"
#include "tests/temporary_folder.h"

namespace gabarit::motorcycle {
namespace {

int exit_code(const std::string& arguments) {
  const std::string command = std::string(GENERATE_MOTORCYCLE) + " " + arguments + " >/dev/null 2>&1";
  return WEXITSTATUS(std::system(command.c_str()));  // NOLINT
}

constexpr const char* quick = " --step 6 --sag 0.4";

TEST(GenerateMotorcycle, two_runs_write_the_same_bytes) {
  const TemporaryFolder folder;
  const auto a = folder / "a.stl", b = folder / "b.stl";
  ASSERT_EQ(exit_code("--out " + a.string() + quick), 0);
  ASSERT_EQ(exit_code("--out " + b.string() + quick), 0);
  EXPECT_TRUE(content(a) == content(b));
}

TEST(GenerateMotorcycle, the_file_holds_the_facets_of_the_library_and_the_list_its_parts) {
  const TemporaryFolder folder;
  const auto stl = folder / "m.stl", list = folder / "m.json";
  ASSERT_EQ(exit_code("--out " + stl.string() + " --parts " + list.string() + quick), 0);
  const auto loaded = load(stl);
  ASSERT_TRUE(loaded);
  Parts all = parts();
  const TriangleMesh made = mesh(all, grids(all, {.sag = 0.4, .step = 6}));
  EXPECT_EQ(loaded->mesh.vertices, made.vertices);
  EXPECT_EQ(loaded->mesh.facets, made.facets);
  const auto json = nlohmann::json::parse(content(list));
  ASSERT_EQ(json["parts"].size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(json["parts"][i]["name"], all[i].name);
    EXPECT_EQ(json["parts"][i]["first_facet"], all[i].first);
  }
}

TEST(GenerateMotorcycle, what_is_wrong_ends_with_exit_code_2) {
  const TemporaryFolder folder;
  const std::string out = "--out " + (folder / "m.stl").string();
  for (const std::string& wrong : {std::string(), out + " --step 0", out + " --step nan", out + " --sag -1",
                                   out + " --wheels 3", std::string("--out /nonexistent/m.stl")}) {
    EXPECT_EQ(exit_code(wrong), 2) << wrong;
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace gabarit::motorcycle
