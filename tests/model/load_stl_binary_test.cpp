#include <cstring>
#include <limits>

#include <gmock/gmock.h>

#include "model/load_stl.h"
#include "tests/model/mesh_files.h"

namespace gabarit {
namespace {

using mesh_files::binary_stl;
using mesh_files::corners;
using mesh_files::load_bytes;
using mesh_files::said;
using testing::HasSubstr;

const shapes::Triangles cube = shapes::rounded_to_float(shapes::gridded_box({0, 0, 0}, {30, 20, 10.1}, 7));

void announce(std::string& bytes, std::uint32_t facets) { std::memcpy(bytes.data() + 80, &facets, 4); }

TEST(load_binary_stl, keeps_every_facet_in_the_order_of_the_file) {
  const shapes::Triangles shuffled = shapes::permuted(cube, 1);
  const Result<Model> model = load_bytes("part.stl", binary_stl(shuffled));
  ASSERT_TRUE(model);
  EXPECT_EQ(model->format, "binary STL");
  EXPECT_EQ(corners(*model), shuffled);
  EXPECT_EQ(model->mesh.vertices.size(), shapes::mesh(cube).vertices.size());
  EXPECT_TRUE(watertight(model->defects));
  EXPECT_TRUE(model->warnings.empty());
}

TEST(load_binary_stl, a_header_that_begins_with_solid_is_no_ascii_file) {
  std::string bytes = binary_stl(cube);
  bytes.replace(0, 18, "solid facet normal");
  const Result<Model> model = load_bytes("part.STL", bytes);
  ASSERT_TRUE(model);
  EXPECT_EQ(corners(*model), cube);
}

TEST(load_binary_stl, keeps_duplicate_degenerate_and_nan_facets_and_counts_them) {
  shapes::Triangles triangles = cube;
  triangles.push_back(cube[3]);
  triangles.push_back({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}});
  triangles.push_back({{{0, 0, 0}, {std::numeric_limits<float>::quiet_NaN(), 0, 0}, {0, 1, 0}}});
  triangles.push_back({{{0, 0, 0}, {std::numeric_limits<float>::infinity(), 0, 0}, {0, 1, 0}}});
  const Result<Model> model = load_bytes("part.stl", binary_stl(triangles));
  ASSERT_TRUE(model);
  EXPECT_EQ(model->mesh.facet_count(), triangles.size());
  EXPECT_EQ(model->defects.duplicate, 1U);
  EXPECT_EQ(model->defects.degenerate, 1U);
  EXPECT_EQ(model->defects.not_finite, 2U);
  EXPECT_EQ(model->box.max, (Vec3d{30, 20, static_cast<float>(10.1)}));
}

TEST(load_binary_stl, a_file_that_is_cut_short_is_refused_with_both_counts) {
  const std::string bytes = binary_stl(cube);
  const std::size_t n = cube.size();
  EXPECT_THAT(said(load_bytes("part.stl", bytes.substr(0, 84 + 50 * (n - 1) + 49))),
              HasSubstr("part.stl: error: the header announces " + std::to_string(n) +
                        " facets, the file ends after " + std::to_string(n - 1)));
}

TEST(load_binary_stl, a_header_that_announces_less_than_there_is_is_refused) {
  std::string bytes = binary_stl(cube);
  announce(bytes, 1);
  EXPECT_THAT(said(load_bytes("part.stl", bytes)), HasSubstr("announces 1 facets, the file holds"));
  announce(bytes, 0);
  EXPECT_THAT(said(load_bytes("part.stl", bytes)), HasSubstr("announces 0 facets, the file holds"));
}

TEST(load_binary_stl, a_header_near_2_to_the_32_allocates_nothing) {
  std::string bytes = binary_stl(cube);
  for (const std::uint32_t lie : {0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU}) {
    announce(bytes, lie);
    EXPECT_THAT(said(load_bytes("part.stl", bytes)),
                HasSubstr("announces " + std::to_string(lie) + " facets, the file ends after"));
  }
}

TEST(load_binary_stl, a_few_bytes_behind_the_last_facet_are_a_warning) {
  const Result<Model> model = load_bytes("part.stl", binary_stl(cube) + std::string(3, '\0'));
  ASSERT_TRUE(model);
  EXPECT_EQ(corners(*model), cube);
  EXPECT_THAT(said(model), HasSubstr("3 bytes after the last facet were not read"));
}

TEST(load_binary_stl, a_header_without_facets_is_no_model) {
  EXPECT_THAT(said(load_bytes("part.stl", binary_stl({}))), HasSubstr("holds no facet"));
}

TEST(load_binary_stl, an_exact_size_tells_an_stl_file_under_any_known_name) {
  const Result<Model> model = load_bytes("part.obj", binary_stl(cube));
  ASSERT_TRUE(model);
  EXPECT_EQ(corners(*model), cube);
  EXPECT_THAT(said(model), HasSubstr("the content is that of a .stl file, whatever the name says"));
}

}  // namespace
}  // namespace gabarit
