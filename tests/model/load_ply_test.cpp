#include "model/load_ply.h"

#include <gmock/gmock.h>

#include "tests/model/mesh_files.h"

namespace gabarit {
namespace {

using mesh_files::corners;
using mesh_files::load_bytes;
using mesh_files::said;
using testing::HasSubstr;

const shapes::Triangles box = shapes::permuted(shapes::gridded_box({0, 0, 0}, {30, 20, 10.1}, 7), 1);

std::string with_header(const std::string& header, const std::string& data) {
  return "ply\n" + header + "end_header\n" + data;
}

const std::string ascii = "format ascii 1.0\n";
const std::string little = "format binary_little_endian 1.0\n";
const std::string three_points = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string one_face = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string points = "0 0 0\n20 0 0\n0 20 0\n";

TEST(load_ply, keeps_every_facet_in_order_in_all_three_forms) {
  for (const PlyFormat format : {PlyFormat::ascii, PlyFormat::little_endian, PlyFormat::big_endian}) {
    const Result<Model> model = load_bytes("part.ply", mesh_files::ply(box, format));
    ASSERT_TRUE(model) << said(model);
    EXPECT_EQ(corners(*model), box);
    EXPECT_EQ(model->format, "PLY");
  }
}

TEST(load_ply, reads_every_type_of_number) {
  const std::string header =
      "format binary_big_endian 1.0\nelement vertex 3\nproperty char a\nproperty short x\n"
      "property uchar y\nproperty int8 z\nproperty float64 b\n"
      "element face 1\nproperty list ushort uint8 vertex_index\nproperty int c\n";
  const std::string row_rest(8, '\0');
  const std::string data = std::string("\1\0\0\0\0", 5) + row_rest + std::string("\1\xFF\xEC\0\0", 5) +
                           row_rest + std::string("\1\0\0\xC8\x9C", 5) + row_rest +
                           std::string("\0\3\0\1\2\0\0\0\7", 9);
  const Result<Model> model = load_bytes("part.ply", with_header(header, data));
  ASSERT_TRUE(model) << said(model);
  EXPECT_EQ(corners(*model), (shapes::Triangles{{{{0, 0, 0}, {-20, 0, 0}, {0, 200, -100}}}}));
}

TEST(load_ply, passes_over_other_properties_and_elements_in_any_order) {
  const Result<Model> model = load_bytes(
      "part.ply",
      with_header(ascii + "comment by hand\nobj_info none\n" + one_face +
                      "property list uchar float quality\nelement edge 2\nproperty int a\n" + three_points,
                  "3 0 1 2 2 0.5 0.5\n7\n8\n" + points));
  ASSERT_TRUE(model) << said(model);
  EXPECT_EQ(model->mesh.facets, (std::vector<std::array<VertexId, 3>>{{0, 1, 2}}));
}

TEST(load_ply, any_line_end_and_comments_among_the_data_will_do) {
  std::string text = with_header(ascii + three_points + one_face, points + "comment here too\n\n3 0 1 2\n");
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    EXPECT_TRUE(load_bytes("part.ply", other)) << said(load_bytes("part.ply", other));
  }
}

TEST(load_ply, a_binary_header_may_end_its_lines_in_any_way) {
  // The first byte of the data is a line feed.
  const shapes::Triangles one{{{{2.0000019073486328, 0, 0}, {20, 0, 0}, {0, 20, 0}}}};
  std::string text = mesh_files::ply(one, PlyFormat::little_endian);
  const std::size_t data = text.find("end_header\n") + 11;
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string other;
    for (const char c : text.substr(0, data)) other += c == '\n' ? end : std::string(1, c);
    std::string bytes = text.substr(data);
    bytes[0] = '\n';
    const Result<Model> model = load_bytes("part.ply", other + bytes);
    ASSERT_TRUE(model) << said(model);
    EXPECT_NEAR(model->mesh.corner(0, 0).x, one[0][0].x, 1e-9);
  }
}

TEST(load_ply, sizes_are_checked_before_anything_is_allocated) {
  EXPECT_THAT(
      said(load_bytes("part.ply", with_header(little + "element vertex 4000000000000\nproperty float x\n"
                                                       "property float y\nproperty float z\n",
                                              ""))),
      HasSubstr("announces 4000000000000 of the element 'vertex', more than 0 bytes can hold"));
  EXPECT_THAT(said(load_bytes("part.ply", with_header(ascii + three_points +
                                                          "element face 1\nproperty list uint int "
                                                          "vertex_indices\n",
                                                      points + "2147483648 0 1 2\n"))),
              HasSubstr("part.ply:13:1: error: face 1 has a list of 2147483648 values, 6 bytes are left"));
  EXPECT_THAT(said(load_bytes("part.ply", with_header(ascii + three_points +
                                                          "element face 1\nproperty list int int "
                                                          "vertex_indices\n",
                                                      points + "-1 0 1 2\n"))),
              HasSubstr("face 1 has a list of -1 values"));
  EXPECT_THAT(said(load_bytes("part.ply", with_header(ascii + "element nothing 9000000000000000000\n" +
                                                          three_points + one_face,
                                                      points + "3 0 1 2\n"))),
              "");
}

TEST(load_ply, numbers_out_of_range_are_refused) {
  const auto message = [](const std::string& face) {
    return said(load_bytes("part.ply", with_header(ascii + three_points + one_face, points + face)));
  };
  EXPECT_THAT(message("3 0 1 3\n"), HasSubstr("a face refers to point 3, the last one is 2"));
  EXPECT_THAT(message("3 0 1 -1\n"), HasSubstr("part.ply:13:1: error: face 1 refers to point -1"));
  EXPECT_THAT(message("3 0 1 1.5\n"), HasSubstr("found '1.5' where a whole number should stand"));
  EXPECT_THAT(
      message("3 0 1\n"),
      HasSubstr(
          "part.ply:13:1: error: face 1 has a list of 3 values, 4 bytes are left: the file is cut short or"));
  EXPECT_THAT(message("3 0 1 2\n3 0 1 2\n"), HasSubstr("the file goes on after what its header announces"));
}

TEST(load_ply, a_binary_file_that_is_cut_short_or_goes_on_is_refused) {
  const std::string bytes = mesh_files::ply(box, PlyFormat::big_endian);
  EXPECT_THAT(said(load_bytes("part.ply", bytes.substr(0, bytes.size() - 1))),
              HasSubstr(": it is cut short; export it again"));
  EXPECT_THAT(said(load_bytes("part.ply", bytes + std::string(13, '\0'))), HasSubstr("the file goes on"));
  EXPECT_TRUE(load_bytes("part.ply", bytes + "\n"));
}

TEST(load_ply, a_header_that_says_nonsense_is_refused_at_its_line) {
  const auto message = [](const std::string& header) {
    return said(load_bytes("part.ply", with_header(header, "")));
  };
  EXPECT_THAT(message("format binary_middle_endian 1.0\n"),
              HasSubstr("part.ply:2:1: error: the format should be"));
  EXPECT_THAT(message(""), HasSubstr("the PLY header has no 'format'"));
  EXPECT_THAT(message(ascii + "element vertex -3\n"),
              HasSubstr("part.ply:3:1: error: the number of elements"));
  EXPECT_THAT(message(ascii + "property float x\n"), HasSubstr("a property stands before the first element"));
  EXPECT_THAT(message(ascii + "element vertex 3\nproperty half x\n"),
              HasSubstr("'half' is no type that PLY knows"));
  EXPECT_THAT(message(ascii + "element vertex 3\nproperty list float int x\n"), HasSubstr("a list's length"));
  EXPECT_THAT(message(ascii + three_points + three_points), HasSubstr("two elements are called 'vertex'"));
  EXPECT_THAT(message(ascii + "element vertex 1\nproperty float x\nproperty float y\n"),
              HasSubstr("x, y and z"));
  EXPECT_THAT(message(ascii + "element face 1\nproperty int vertex_indices\n"), HasSubstr("one list called"));
  EXPECT_THAT(message(ascii + "elements vertex 1\n"), HasSubstr("found 'elements' in the PLY header"));
  EXPECT_THAT(said(load_bytes("part.ply", "ply\n" + ascii)), HasSubstr("the PLY header has no 'end_header'"));
}

TEST(load_ply, triangle_strips_are_refused_not_lost) {
  EXPECT_THAT(said(load_bytes("part.ply", with_header(ascii + three_points +
                                                          "element tristrips 1\nproperty list int "
                                                          "int vertex_indices\n",
                                                      points + "4 0 1 2 -1\n"))),
              HasSubstr("the element 'tristrips' holds faces in a form that cannot be read"));
}

}  // namespace
}  // namespace gabarit
