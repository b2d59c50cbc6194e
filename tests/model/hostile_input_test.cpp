#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/model/mesh_files.h"
#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

using mesh_files::load_bytes;
using mesh_files::said;
using testing::AllOf;
using testing::HasSubstr;

struct Format {
  const char* file;
  std::string bytes;
  bool counted;  // the file itself says how many facets it has
};

// Four facets: small files, so that every way to cut them can be tried.
const Vec3d a{0, 0, 0};
const Vec3d b{100, 0, 0};
const Vec3d c{0, 20.5, 0};
const Vec3d d{0, 0, 10};
const shapes::Triangles solid{{{a, c, b}}, {{a, b, d}}, {{b, c, d}}, {{c, a, d}}};

std::vector<Format> every_format() {
  return {{"part.stl", mesh_files::binary_stl(solid), true},
          {"part.stl", mesh_files::ascii_stl(solid), true},
          {"part.obj", mesh_files::obj(solid), false},
          {"part.ply", mesh_files::ply(solid, PlyFormat::ascii), true},
          {"part.ply", mesh_files::ply(solid, PlyFormat::little_endian), true},
          {"part.ply", mesh_files::ply(solid, PlyFormat::big_endian), true},
          {"part.off", mesh_files::off(solid), true}};
}

// Loads from one file that is written again and again: quicker than a folder each.
class Loading {
 public:
  Result<Model> operator()(const char* file, const std::string& bytes) const {
    put(folder_ / file, bytes);
    LoadOptions options;
    options.threads = 1;
    return load(folder_ / file, options);
  }

 private:
  TemporaryFolder folder_;
};

bool is_error_with_the_files_name(const Result<Model>& result, const char* file) {
  return !result && !result.error().empty() && said(result).find(std::string(file)) != std::string::npos;
}

TEST(hostile_input, no_file_that_is_cut_short_passes_for_a_whole_one) {
  const Loading load_file;
  for (const Format& format : every_format()) {
    for (std::size_t n = 0; n < format.bytes.size(); ++n) {
      const Result<Model> result = load_file(format.file, format.bytes.substr(0, n));
      if (is_error_with_the_files_name(result, format.file)) continue;
      ASSERT_TRUE(result);
      if (format.counted) {
        // Only what follows the last facet may be missing.
        EXPECT_EQ(mesh_files::corners(*result), solid) << format.file << " cut at " << n;
      } else {
        // OBJ does not say how much there should be: all that can be seen is a line that breaks off.
        const bool whole_lines = format.bytes[n - 1] == '\n';
        EXPECT_GE(result->mesh.facet_count(), 1U);
        EXPECT_LE(result->mesh.facet_count(), solid.size());
        EXPECT_EQ(said(result).find("the last line has no end") == std::string::npos, whole_lines) << n;
      }
    }
  }
}

TEST(hostile_input, a_damaged_byte_loses_no_facet_without_a_word) {
  const Loading load_file;
  for (const Format& format : every_format()) {
    std::mt19937 random(20261125);
    for (int round = 0; round < 600; ++round) {
      std::string bytes = format.bytes;
      bytes[random() % bytes.size()] ^= static_cast<char>(1U << random() % 8);
      const Result<Model> result = load_file(format.file, bytes);
      if (is_error_with_the_files_name(result, format.file)) continue;
      ASSERT_TRUE(result);
      if (!format.counted) continue;
      const bool told = said(result).find("left out") != std::string::npos;
      EXPECT_TRUE(told || result->mesh.facet_count() == solid.size()) << format.file << " round " << round;
    }
  }
}

TEST(hostile_input, random_bytes_behind_a_good_beginning_end_in_a_message) {
  const Loading load_file;
  std::mt19937 random(7);
  for (const Format& format : every_format()) {
    for (int round = 0; round < 200; ++round) {
      std::string bytes = format.bytes.substr(0, random() % format.bytes.size());
      for (int i = 0; i < 300; ++i) bytes += static_cast<char>(random());
      const Result<Model> result = load_file(format.file, bytes);
      EXPECT_TRUE(result || is_error_with_the_files_name(result, format.file));
    }
  }
}

TEST(hostile_input, nothing_to_measure_is_an_error_that_says_why) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THAT(said(load_bytes("part.stl", mesh_files::binary_stl({}))),
              HasSubstr("part.stl: error: holds no facet; points, lines and empty solids"));
  EXPECT_THAT(said(load_bytes("part.stl", mesh_files::ascii_stl({}))), HasSubstr("holds no facet"));
  EXPECT_THAT(
      said(load_bytes("part.stl", mesh_files::binary_stl({{{{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                                          {{{infinity, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                                          {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}}))),
      HasSubstr("none of its 3 facets can be measured: 2 have a coordinate that is not a number or infinite, "
                "1 have no area; export it again"));
}

TEST(hostile_input, files_of_84_bytes_and_around_are_told_apart) {
  EXPECT_THAT(said(load_bytes("part.stl", std::string(84, '\0'))), HasSubstr("holds no facet"));
  EXPECT_THAT(said(load_bytes("part.stl", std::string(83, '\0'))),
              HasSubstr("neither a binary nor an ASCII STL"));
  EXPECT_THAT(said(load_bytes("part.stl", std::string(85, '\0'))), HasSubstr("holds no facet"));
  EXPECT_THAT(said(load_bytes("part.stl", std::string(80, '\0') + "\xFF\xFF\xFF\xFF")),
              HasSubstr("announces 4294967295 facets"));
}

TEST(hostile_input, an_ascii_file_may_begin_with_anything_that_is_a_comment) {
  const std::string text = mesh_files::ascii_stl(solid);
  for (const std::string start : {"\n\n\n", "# made by hand\n", "\xEF\xBB\xBF", "   \t", "; solid\r\n"}) {
    const Result<Model> result = load_bytes("part.stl", start + text);
    ASSERT_TRUE(result) << said(result);
    EXPECT_EQ(mesh_files::corners(*result), solid);
  }
  EXPECT_THAT(
      said(load_bytes("part.stl", "Exported by X\n" + text)),
      HasSubstr("part.stl:1:1: error: found 'Exported' where 'solid', 'facet' or 'endsolid' should stand"));
}

TEST(hostile_input, text_in_the_wrong_encoding_is_named) {
  for (const Format& format : every_format()) {
    if (format.bytes.find('\0') != std::string::npos) continue;
    std::string wide;
    for (const char letter : format.bytes) wide += {letter, '\0'};
    EXPECT_THAT(said(load_bytes(format.file, wide)), HasSubstr("is UTF-16 text; save it as UTF-8"));
    EXPECT_THAT(said(load_bytes(format.file, "\xFF\xFE" + wide)), HasSubstr("is UTF-16 text"));
    EXPECT_THAT(said(load_bytes(format.file, "\xFE\xFF" + wide.substr(1))), HasSubstr("is UTF-16 text"));
    const Result<Model> marked = load_bytes(format.file, "\xEF\xBB\xBF" + format.bytes);
    ASSERT_TRUE(marked) << said(marked);
    EXPECT_EQ(mesh_files::corners(*marked), solid);
  }
}

TEST(hostile_input, a_zero_byte_among_text_is_found_at_its_line) {
  std::string text = mesh_files::ascii_stl(solid);
  text[text.find("outer loop", 150)] = '\0';
  EXPECT_THAT(said(load_bytes("part.stl", text)),
              AllOf(HasSubstr("part.stl:"), HasSubstr("found ' uter' where 'outer'")));
}

TEST(hostile_input, a_line_without_an_end_is_answered_at_once) {
  const std::string endless(8'000'000, 'x');
  EXPECT_THAT(said(load_bytes("part.stl", "solid " + endless)), HasSubstr("'endsolid' should stand"));
  EXPECT_THAT(said(load_bytes("part.stl", "solid\nfacet" + endless)),
              HasSubstr("part.stl:2:1: error: found 'facetxxx"));
  EXPECT_THAT(said(load_bytes("part.obj", "v " + endless)), HasSubstr("part.obj:1:1: error: found 'xxx"));
  EXPECT_THAT(said(load_bytes("part.off", "OFF " + endless)),
              HasSubstr("part.off:1:1: error: the numbers of"));
  EXPECT_THAT(said(load_bytes("part.ply", "ply\nformat ascii 1.0\ncomment " + endless)),
              HasSubstr("the PLY header has no 'end_header'"));
  EXPECT_THAT(said(load_bytes("part.stl", std::string(8'000'000, ' '))),
              HasSubstr("neither a binary nor an ASCII"));
}

TEST(hostile_input, a_polygon_of_many_corners_that_crosses_itself_is_cut_in_time) {
  std::string text;
  std::mt19937 random(3);
  for (int i = 0; i < 10'000; ++i) text += fmt::format("v {} {} 0\n", random() % 1000, random() % 1000);
  text += "f";
  for (int i = 1; i <= 10'000; ++i) text += fmt::format(" {}", i);
  const Result<Model> result = load_bytes("part.obj", text + "\n");
  ASSERT_TRUE(result) << said(result);
  EXPECT_EQ(result->mesh.facet_count(), 9'998U);
}

TEST(hostile_input, coordinates_at_the_ends_of_double_do_no_harm) {
  for (const char* const size : {"1e308", "1e200", "1e154", "1e-160", "1e-308", "4.9e-324"}) {
    const Result<Model> result = load_bytes(
        "part.obj",
        fmt::format(
            "v 0 0 0\nv {0} 0 0\nv 0 {0} 0\nv 0 0 {0}\nv 9 9 9\nv 9 10 9\nf 1 2 3\nf 1 3 4\nf 1 5 6\n",
            size));
    ASSERT_TRUE(result) << size << said(result);
    EXPECT_EQ(result->mesh.facet_count(), 3U);
    EXPECT_EQ(result->defects.not_finite, 0U);
  }
}

TEST(hostile_input, the_content_decides_where_a_name_lies) {
  for (const Format& format : every_format()) {
    if (!format.counted) continue;  // OBJ has no beginning of its own
    const Result<Model> result = load_bytes("part.obj", format.bytes);
    ASSERT_TRUE(result) << said(result);
    EXPECT_EQ(mesh_files::corners(*result), solid);
    EXPECT_THAT(said(result), HasSubstr("whatever the name says"));
  }
}

TEST(hostile_input, a_name_in_the_wrong_encoding_leaves_no_bad_text_in_the_model) {
  const Result<Model> result = load_bytes("K\xE4se.ply", mesh_files::ply(solid));
  ASSERT_TRUE(result) << said(result);
  EXPECT_EQ(result->file, "K\xEF\xBF\xBDse.ply");
  EXPECT_EQ(result->bodies, std::vector<std::string>{"K\xEF\xBF\xBDse"});
}

}  // namespace
}  // namespace gabarit
