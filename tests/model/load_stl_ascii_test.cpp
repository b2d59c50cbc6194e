#include <algorithm>
#include <cctype>

#include <gmock/gmock.h>

#include "tests/model/mesh_files.h"

namespace gabarit {
namespace {

using mesh_files::ascii_stl;
using mesh_files::corners;
using mesh_files::load_bytes;
using mesh_files::said;
using testing::ElementsAre;
using testing::HasSubstr;

const shapes::Triangles cube = shapes::gridded_box({0, 0, 0}, {30, 20, 10.1}, 7);

std::string one_facet(const std::string& corner = "0 0 0") {
  return "facet normal 0 0 1\nouter loop\nvertex " + corner +
         "\nvertex 20 0 0\nvertex 0 20 0\nendloop\nendfacet\n";
}

TEST(load_ascii_stl, keeps_every_facet_in_order_whatever_ends_a_line) {
  for (const std::string end : {"\n", "\r\n", "\r", " ", "\t\n\n"}) {
    const Result<Model> model = load_bytes("part.stl", ascii_stl(cube, end));
    ASSERT_TRUE(model) << said(model);
    EXPECT_EQ(model->format, "ASCII STL");
    EXPECT_EQ(corners(*model), cube);
    EXPECT_EQ(model->bodies, std::vector<std::string>{"part"});
  }
}

TEST(load_ascii_stl, reads_upper_case_words) {
  std::string text = ascii_stl(cube);
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  const Result<Model> model = load_bytes("part.stl", text);
  ASSERT_TRUE(model);
  EXPECT_EQ(corners(*model), cube);
}

TEST(load_ascii_stl, makes_a_body_of_every_solid) {
  const Result<Model> model = load_bytes("part.stl", ascii_stl({cube[0], cube[1]}, "\n", "left wheel") +
                                                         ascii_stl({cube[2]}, "\n", "") +
                                                         ascii_stl({cube[3]}, "\n", "left wheel # by hand"));
  ASSERT_TRUE(model);
  EXPECT_THAT(model->bodies, ElementsAre("left wheel", "solid 2", "left wheel"));
  EXPECT_THAT(model->mesh.body, ElementsAre(0, 0, 1, 2));
}

TEST(load_ascii_stl, a_file_of_one_line_keeps_the_facets_behind_a_name) {
  const Result<Model> model =
      load_bytes("part.stl", ascii_stl({cube[0]}, " ") + ascii_stl({cube[1], cube[2]}, " "));
  ASSERT_TRUE(model) << said(model);
  EXPECT_EQ(corners(*model), (shapes::Triangles{cube[0], cube[1], cube[2]}));
}

TEST(load_ascii_stl, passes_over_comments_and_whatever_stands_before_the_first_solid_in_them) {
  const Result<Model> model =
      load_bytes("part.stl", "# solid no\n; written by hand\n// facet\nsolid a # b\n" + one_facet() +
                                 "endsolid a ; end\n# end");
  ASSERT_TRUE(model) << said(model);
  EXPECT_EQ(model->mesh.facet_count(), 1U);
  EXPECT_THAT(model->bodies, ElementsAre("a"));
}

TEST(load_ascii_stl, reads_numbers_of_every_spelling_and_counts_those_that_are_none) {
  for (const std::string corner :
       {"nan 0 0", "NaN 0 0", "-nan 0 0", "nan(ind) 0 0", "inf 0 0", "-Infinity 0 0", "1.#QNAN 0 0",
        "-1.#IND00 0 0", "1.#INF 0 0", "1e999 0 0", "-1e999 0 0"}) {
    const Result<Model> model =
        load_bytes("part.stl", "solid\n" + one_facet(corner) + one_facet() + "endsolid\n");
    ASSERT_TRUE(model) << corner << said(model);
    EXPECT_EQ(model->defects.not_finite, 1U) << corner;
    EXPECT_EQ(model->mesh.facet_count(), 2U);
  }
  const Result<Model> model =
      load_bytes("part.stl", "solid\n" + one_facet("+1.5E+1 -.5 1e-999") + "endsolid\n");
  ASSERT_TRUE(model) << said(model);
  EXPECT_EQ(model->mesh.corner(0, 0), (Vec3d{15, -0.5, 0}));
}

TEST(load_ascii_stl, says_at_which_line_what_was_wanted) {
  EXPECT_THAT(said(load_bytes("part.stl", "solid\n" + one_facet("0 1,5 0"))),
              HasSubstr("part.stl:4:1: error: found '1,5' where a number should stand"));
  EXPECT_THAT(said(load_bytes("part.stl", "solid\r\nfacet normal 0 0 1\r\nouter ring\r\n")),
              HasSubstr("part.stl:3:1: error: found 'ring' where 'loop' should stand"));
  EXPECT_THAT(said(load_bytes("part.stl", "solid a\rfacet normal 0 0 1\router loop\rvertices")),
              HasSubstr("part.stl:4:1: error: found 'vertices' where 'vertex' should stand"));
}

TEST(load_ascii_stl, a_facet_of_four_corners_is_an_error_not_a_triangle) {
  std::string text = "solid\n" + one_facet() + "endsolid\n";
  text.insert(text.find("endloop"), "vertex 20 20 0\n");
  EXPECT_THAT(said(load_bytes("part.stl", text)), HasSubstr("found 'vertex' where 'endloop' should stand"));
}

TEST(load_ascii_stl, a_file_without_its_endsolid_is_cut_short) {
  EXPECT_THAT(said(load_bytes("part.stl", "solid part\n" + one_facet())),
              HasSubstr("the file ends where 'endsolid' should stand: it is cut short; export it again"));
}

TEST(load_ascii_stl, many_names_in_the_wrong_encoding_are_one_warning) {
  std::string text;
  for (int i = 0; i < 20'000; ++i)
    text += "solid K\xE4se\n" + std::string(i == 0 ? one_facet() : "") + "endsolid\n";
  const Result<Model> model = load_bytes("part.stl", text);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->warnings.size(), 1U);
  EXPECT_THAT(said(model), HasSubstr("20000 names of solids are not plain UTF-8"));
  EXPECT_EQ(model->bodies[0], "K\xEF\xBF\xBDse");
}

}  // namespace
}  // namespace gabarit
