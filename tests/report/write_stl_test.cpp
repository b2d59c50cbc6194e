#include "report/write_stl.h"

#include <cstring>

#include <gmock/gmock.h>

#include "model/load.h"
#include "tests/report/sample_report.h"
#include "tests/shapes.h"
#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string stl_of(const TriangleMesh& mesh, const std::vector<FacetId>& facets,
                   const TemporaryFolder& folder) {
  OutputFile file(folder / "out.stl");
  write_stl(mesh, facets, "Gabarit test", file);
  file.commit();
  return content(folder / "out.stl");
}

TEST(write_stl, facets_come_back_bit_for_bit_and_outward) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = shapes::mesh(shapes::rounded_to_float(shapes::sphere(12.3, 8, 9)));
  const std::vector<FacetId> facets{0, 5, 17, 40};
  stl_of(mesh, facets, folder);
  const Result<Model> read = load(folder / "out.stl");
  ASSERT_TRUE(read.has_value());
  ASSERT_EQ(read->mesh.facet_count(), facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    EXPECT_EQ(read->mesh.corners(static_cast<FacetId>(i)), mesh.corners(facets[i]));
  }
}

TEST(write_stl, normals_point_out_of_the_solid) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = shapes::mesh(shapes::box({0, 0, 0}, {1, 1, 1}));
  const std::string bytes = stl_of(mesh, {0}, folder);
  std::array<float, 3> normal{};
  std::memcpy(normal.data(), bytes.data() + 84, sizeof normal);
  const Vec3d expected = facet_normal(mesh, 0);
  EXPECT_EQ((Vec3d{normal[0], normal[1], normal[2]}), expected);
}

TEST(write_stl, no_facets_make_a_valid_empty_file) {
  const TemporaryFolder folder;
  const std::string bytes = stl_of(shapes::mesh(shapes::box({0, 0, 0}, {1, 1, 1})), {}, folder);
  EXPECT_EQ(bytes.size(), 84U);
  EXPECT_EQ(bytes.substr(80), std::string(4, '\0'));
  EXPECT_NE(bytes.substr(0, 5), "solid");
}

TEST(failing_facets, of_a_rule_are_those_judged_to_fail) {
  SampleReport sample;
  EXPECT_THAT(failing_facets(sample.rule("failing")), ElementsAre(0U, 2U));
  EXPECT_THAT(failing_facets(sample.rule("undecided")), IsEmpty());
}

TEST(failing_facets, of_all_rules_appear_once) {
  SampleReport sample;
  sample.outcome.results.push_back(sample.rule("failing"));
  EXPECT_THAT(failing_facets(sample.outcome), ElementsAre(0U, 2U));
}

}  // namespace
}  // namespace gabarit
