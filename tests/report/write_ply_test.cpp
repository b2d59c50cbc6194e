#include "report/write_ply.h"

#include <cmath>
#include <cstring>

#include <gmock/gmock.h>

#include "tests/report/sample_report.h"
#include "tests/temporary_folder.h"

namespace gabarit {
namespace {

struct Face {
  std::array<std::int32_t, 3> vertices;
  double value, lower, upper;
  int selected, verdict;
};

struct Ply {
  std::string header;
  std::vector<Vec3d> vertices;
  std::vector<Face> faces;
};

// Reads what the tests write, on the machines they run on, which are little-endian.
Ply read_back(const std::string& bytes, std::size_t vertices, std::size_t faces) {
  const std::string end = "end_header\n";
  const std::size_t start = bytes.find(end) + end.size();
  Ply ply{bytes.substr(0, start), std::vector<Vec3d>(vertices), {}};
  const char* at = bytes.data() + start;
  std::memcpy(ply.vertices.data(), at, 24 * vertices);
  at += 24 * vertices;
  for (std::size_t f = 0; f < faces; ++f, at += 39) {
    Face face{};
    EXPECT_EQ(at[0], 3);
    std::memcpy(face.vertices.data(), at + 1, 12);
    std::memcpy(&face.value, at + 13, 8);
    std::memcpy(&face.lower, at + 21, 8);
    std::memcpy(&face.upper, at + 29, 8);
    face.selected = at[37], face.verdict = at[38];
    ply.faces.push_back(face);
  }
  EXPECT_EQ(at, bytes.data() + bytes.size());
  return ply;
}

Ply ply_of(const SampleReport& sample, const RuleResult& r, const std::vector<FacetVerdict>* verdicts) {
  const TemporaryFolder folder;
  OutputFile file(folder / "out.ply");
  write_ply({&sample.model.mesh, &r.region, &r.field, verdicts, 1, "Gabarit test"}, file);
  file.commit();
  return read_back(content(folder / "out.ply"), sample.model.mesh.vertices.size(), 12);
}

TEST(write_ply, declares_the_properties_of_the_contract_in_their_order) {
  SampleReport sample;
  const Ply ply = ply_of(sample, sample.rule("failing"), nullptr);
  EXPECT_EQ(
      ply.header,
      "ply\nformat binary_little_endian 1.0\ncomment Gabarit test\nelement vertex 8\nproperty double x\n"
      "property double y\nproperty double z\nelement face 12\nproperty list uchar int vertex_indices\n"
      "property double value\nproperty double lower\nproperty double upper\nproperty uchar selected\n"
      "property uchar verdict\nend_header\n");
}

TEST(write_ply, holds_every_facet_in_input_order_with_its_values) {
  SampleReport sample;
  const RuleResult& r = sample.rule("failing");
  const Ply ply = ply_of(sample, r, &r.facet_verdicts);
  for (std::size_t f = 0; f < 12; ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = static_cast<std::size_t>(ply.faces[f].vertices[i]);
      EXPECT_EQ(ply.vertices[v], sample.model.mesh.corner(static_cast<FacetId>(f), static_cast<int>(i)));
    }
  }
  EXPECT_EQ(ply.faces[2].value, 1.25);
  EXPECT_EQ(ply.faces[2].lower, 1);
  EXPECT_EQ(ply.faces[2].upper, 1.5);
  EXPECT_EQ(ply.faces[2].selected, 1);
  EXPECT_EQ(ply.faces[2].verdict, 2);
  EXPECT_EQ(ply.faces[4].verdict, 1);
}

TEST(write_ply, facets_without_a_value_are_nan_and_not_examined) {
  SampleReport sample;
  const RuleResult& r = sample.rule("failing");
  const Face face = ply_of(sample, r, &r.facet_verdicts).faces[1];
  EXPECT_TRUE(std::isnan(face.value) && std::isnan(face.lower) && std::isnan(face.upper));
  EXPECT_EQ(face.selected, 0);
  EXPECT_EQ(face.verdict, 0);
}

TEST(write_ply, without_verdicts_nothing_is_judged) {
  SampleReport sample;
  for (const Face& face : ply_of(sample, sample.rule("failing"), nullptr).faces) EXPECT_EQ(face.verdict, 0);
}

}  // namespace
}  // namespace gabarit
