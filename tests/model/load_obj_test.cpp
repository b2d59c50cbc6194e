#include "model/load_obj.h"

#include <gmock/gmock.h>

#include "tests/model/mesh_files.h"

namespace gabarit {
namespace {

using mesh_files::corners;
using mesh_files::load_bytes;
using mesh_files::said;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string square = "v 0 0 0\nv 20 0 0\nv 20 20 0\nv 0 20 0\n";

std::vector<std::array<VertexId, 3>> facets(const Result<Model>& model) {
  return model ? model->mesh.facets : std::vector<std::array<VertexId, 3>>{};
}

using Facets = std::vector<std::array<VertexId, 3>>;

TEST(load_obj, keeps_every_facet_in_order_in_double_precision) {
  const shapes::Triangles box = shapes::permuted(shapes::gridded_box({0, 0, 0}, {30, 20, 10.1}, 7), 1);
  const Result<Model> model = load_bytes("part.obj", mesh_files::obj(box));
  ASSERT_TRUE(model) << said(model);
  EXPECT_EQ(corners(*model), box);
  EXPECT_EQ(model->bodies, std::vector<std::string>{"default"});
}

TEST(load_obj, cuts_a_polygon_of_n_corners_into_n_minus_2_facets) {
  const Result<Model> model = load_bytes("part.obj", square + "f 1 2 3 4\nf 1 2 3\n");
  EXPECT_EQ(facets(model), (Facets{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}));
  EXPECT_THAT(said(model), HasSubstr("note: 1 faces with more than three corners were cut into triangles"));
}

TEST(load_obj, repeated_corners_make_degenerate_facets_that_stay) {
  const Result<Model> model = load_bytes("part.obj", square + "f 1 2 2 3\nf 1 1 2\n");
  ASSERT_TRUE(model) << said(model);
  EXPECT_EQ(model->mesh.facet_count(), 3U);
  EXPECT_EQ(model->defects.degenerate, 2U);
}

TEST(load_obj, reads_every_way_to_write_a_corner) {
  EXPECT_EQ(
      facets(load_bytes("part.obj", square + "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 "
                                             "2/1/1 3/1/1\nf -4 -3 -2\n f\t1//\t2// 3// # tail\n")),
      (Facets{{0, 1, 2}, {0, 1, 2}, {0, 1, 2}, {0, 1, 2}, {0, 1, 2}}));
}

TEST(load_obj, a_backslash_continues_a_line_and_any_line_end_will_do) {
  std::string text = square + "f 1 2 \\\n 3 4\n";
  const Facets two{{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(facets(load_bytes("part.obj", text)), two);
  std::string carriage_returns = text;
  std::replace(carriage_returns.begin(), carriage_returns.end(), '\n', '\r');
  EXPECT_EQ(facets(load_bytes("part.obj", carriage_returns)), two);
}

TEST(load_obj, a_face_may_come_before_its_points) {
  EXPECT_EQ(facets(load_bytes("part.obj", "f 1 2 3\n" + square)), (Facets{{0, 1, 2}}));
}

TEST(load_obj, objects_and_groups_with_faces_are_bodies) {
  const Result<Model> model =
      load_bytes("part.obj", square + "o empty\no frame\nf 1 2 3\ng wheel left\nf 1 3 4\no frame\nf 1 2 4\n");
  ASSERT_TRUE(model);
  EXPECT_THAT(model->bodies, ElementsAre("frame", "wheel left"));
  EXPECT_THAT(model->mesh.body, ElementsAre(0, 1, 0));
}

TEST(load_obj, numbers_out_of_range_are_refused_at_their_line) {
  const auto message = [](const std::string& face) {
    return said(load_bytes("part.obj", square + face + "\n"));
  };
  EXPECT_THAT(message("f 1 2 5"), HasSubstr("part.obj:5:1: error: a face refers to point 5, the file has 4"));
  EXPECT_THAT(message("f 1 2 0"), HasSubstr("part.obj:5:1: error: found '0' where the number of a point"));
  EXPECT_THAT(message("f -5 2 3"), HasSubstr("found '-5' where the number of a point should stand"));
  EXPECT_THAT(message("f 1 2 99999999999999999999"), HasSubstr("found '99999999999999999999'"));
  EXPECT_THAT(message("f 1 2 4294967297"), HasSubstr("found '4294967297'"));
  EXPECT_THAT(message("f 1 2 3.0"), HasSubstr("found '3.0'"));
  EXPECT_THAT(message("f 1 2 3\nv 1 2"), HasSubstr("part.obj:6:1: error: the line ends where a coordinate"));
  EXPECT_THAT(message("f 1 2 3\nv 1 2 x"), HasSubstr("found 'x' where a coordinate should stand"));
}

TEST(load_obj, what_is_left_out_is_said) {
  const std::string said_of =
      said(load_bytes("part.obj", square + "f 1 2 3\nf 1 2\nF 1 2 3\nsurf 0 1 0 1 1 2 3 4\n"));
  EXPECT_THAT(said_of, HasSubstr("1 faces with fewer than three corners have no surface and were left out"));
  EXPECT_THAT(said_of, HasSubstr("part.obj:7:1: warning: 1 lines begin with a word that OBJ does not know"));
  EXPECT_THAT(said_of, HasSubstr("part.obj:8:1: warning: 1 free-form surfaces (surf) cannot be read"));
}

TEST(load_obj, material_files_are_not_opened) {
  const Result<Model> model =
      load_bytes("part.obj", "mtllib /dev/zero\nusemtl steel\n" + square + "f 1 2 3\n");
  ASSERT_TRUE(model);
  EXPECT_EQ(said(model), "");
}

TEST(load_obj, points_and_lines_are_no_model) {
  EXPECT_THAT(said(load_bytes("part.obj", square + "p 1\nl 1 2\n")), HasSubstr("holds no facet"));
}

TEST(load_obj, a_face_of_more_corners_than_any_part_has_is_refused) {
  std::string text = square + "f";
  for (int i = 0; i < 70'000; ++i) text += " 1";
  EXPECT_THAT(said(load_bytes("part.obj", text + "\n")),
              HasSubstr("face 1 has 70000 corners, more than 65536; export it in triangles"));
}

}  // namespace
}  // namespace gabarit
