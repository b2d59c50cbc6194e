#include "model/load_off.h"

#include <gmock/gmock.h>

#include "tests/model/mesh_files.h"

namespace gabarit {
namespace {

using mesh_files::corners;
using mesh_files::load_bytes;
using mesh_files::said;
using testing::HasSubstr;

const std::string points = "0 0 0\n20 0 0\n20 20 0\n0 20 0\n";
using Facets = std::vector<std::array<VertexId, 3>>;

Facets facets(const std::string& text) {
  const Result<Model> model = load_bytes("part.off", text);
  EXPECT_TRUE(model) << said(model);
  return model ? model->mesh.facets : Facets{};
}

TEST(load_off, keeps_every_facet_in_order_in_double_precision) {
  const shapes::Triangles box = shapes::permuted(shapes::gridded_box({0, 0, 0}, {30, 20, 10.1}, 7), 1);
  const Result<Model> model = load_bytes("part.off", mesh_files::off(box));
  ASSERT_TRUE(model) << said(model);
  EXPECT_EQ(corners(*model), box);
  EXPECT_EQ(model->format, "OFF");
  EXPECT_EQ(model->bodies, std::vector<std::string>{"part"});
}

TEST(load_off, cuts_a_polygon_of_n_corners_into_n_minus_2_facets) {
  EXPECT_EQ(facets("OFF\n4 2 0\n" + points + "4 0 1 2 3\n3 0 1 2\n"),
            (Facets{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
}

TEST(load_off, passes_over_comments_colours_normals_and_odd_spacing) {
  const Facets one{{0, 1, 2}};
  EXPECT_EQ(facets("# solid comment\n\nOFF # keyword\n# counts\n4 1 4\n" + points +
                   "\n  3 0 1 2 0.5 0.5 0.5 # red\n"),
            one);
  EXPECT_EQ(facets("   OFF4 1 0\n" + points + "3 0 1 2\n"), one);
  EXPECT_EQ(facets("OFF 4 1\n" + points + "3\n0\n1\n2"), one);
  EXPECT_EQ(facets("COFF\n3 1 0\n0 0 0 255 0 0 255\n20 0 0 255 0 0 255\n0 20 0 1 1 1 1\n3 0 1 2\n"), one);
  EXPECT_EQ(facets("NOFF\r\n3 1 0\r\n0 0 0 0 0 1\r\n20 0 0 0 0 1\r\n0 20 0 0 0 1\r\n3 0 1 2\r\n"), one);
}

TEST(load_off, what_the_header_announces_must_be_there_and_no_more) {
  EXPECT_THAT(said(load_bytes("part.off", "OFF\n4 2 0\n" + points + "3 0 1 2\n")),
              HasSubstr("part.off:7:1: error: the file ends after 4 points and 1 faces where"));
  EXPECT_THAT(said(load_bytes("part.off", "OFF\n4 1 0\n" + points + "3 0 1 2\n3 0 2 3\n")),
              HasSubstr("part.off:8:1: error: the file goes on after the 1 faces that it announces"));
  EXPECT_THAT(said(load_bytes("part.off", "OFF\n4000000000 1 0\n" + points + "3 0 1 2\n")),
              HasSubstr("announces 4000000000 points and 1 faces, more than"));
  EXPECT_THAT(said(load_bytes("part.off", "OFF\n4 9223372036854775807 0\n" + points)),
              HasSubstr("more than"));
}

TEST(load_off, wrong_numbers_are_refused_at_their_line) {
  EXPECT_THAT(said(load_bytes("part.off", "OFF\n-4 1 0\n" + points)),
              HasSubstr("part.off:2:1: error: the numbers of points and faces should stand here"));
  EXPECT_THAT(said(load_bytes("part.off", "OFF\n4 1 0\n" + points + "3 0 1 4\n")),
              HasSubstr("part.off:7:1: error: found '4' where the number of a point, 0 to 3, should stand"));
  EXPECT_THAT(said(load_bytes("part.off", "OFF\n4 1 0\n" + points + "3 0 1 -1\n")), HasSubstr("found '-1'"));
  EXPECT_THAT(said(load_bytes("part.off", "OFF\n4 1 0\n" + points + "-3 0 1 2\n")),
              HasSubstr("found '-3' where a face's number of corners should stand"));
  EXPECT_THAT(said(load_bytes("part.off", "OFF\n1 1 0\n0 0 z\n")), HasSubstr("found 'z' where a coordinate"));
}

TEST(load_off, refuses_what_it_does_not_read) {
  EXPECT_THAT(said(load_bytes("part.off", "OFF BINARY\n1234")),
              HasSubstr("binary OFF cannot be read; export it as"));
  EXPECT_THAT(said(load_bytes("part.off", "4OFF\n1 1 0\n")), HasSubstr("four or more dimensions"));
  EXPECT_THAT(said(load_bytes("part.off", "v 0 0 0\n")), HasSubstr("the first word should be 'OFF'"));
}

}  // namespace
}  // namespace gabarit
