#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/house/includes.h"
#include "tests/temporary_folder.h"

namespace gabarit::house {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

const fs::path source_tree = GABARIT_SOURCE_DIR;

class PlantedTree : public testing::Test {
 protected:
  void plant(const std::string& file, const std::string& text) { put(tree_ / file, text); }

  const TemporaryFolder folder_;
  const fs::path tree_ = folder_.path();
};

TEST(Layering, no_include_of_the_project_runs_against_the_arrows) {
  EXPECT_THAT(layering_errors(source_tree), IsEmpty());
}

TEST(Layering, the_tree_that_was_read_is_the_real_one) {
  EXPECT_GT(includes(source_tree, {"gpu", "model", "checks", "rules", "report", "cli"}).size(), 50U);
}

TEST_F(PlantedTree, an_arrow_to_the_left_is_found) {
  plant("model/fine.h", "#include \"gpu/vec3.h\"\n#include \"model/other.h\"\n");
  plant("gpu/bad.cpp", "#include <vector>\n  #  include \"model/model.h\"\n");
  EXPECT_THAT(layering_errors(tree_), ElementsAre("gpu/bad.cpp:2: may not include model/model.h"));
}

TEST_F(PlantedTree, nothing_of_the_product_includes_tests_benchmarks_or_examples) {
  plant("checks/a.cpp", "#include \"tests/shapes.h\"\n");
  plant("report/b.cpp", "#include \"../examples/motorcycle/motorcycle.h\"\n");
  EXPECT_THAT(layering_errors(tree_), testing::SizeIs(2));
}

TEST_F(PlantedTree, the_compute_layer_may_have_tests_of_its_own) {
  plant("gpu/tests/a_test.cpp", "#include \"tests/shapes.h\"\n");
  EXPECT_THAT(layering_errors(tree_), IsEmpty());
}

TEST(Layering, the_root_build_file_stays_short) {
  std::ifstream text(source_tree / "CMakeLists.txt");
  int lines = 0;
  for (std::string line; std::getline(text, line);) ++lines;
  EXPECT_GT(lines, 10);
  EXPECT_LE(lines, 60);
}

}  // namespace
}  // namespace gabarit::house
