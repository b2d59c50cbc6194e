#include <random>
#include <sstream>

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <gmock/gmock.h>

#include "model/load_ply.h"
#include "tests/model/mesh_files.h"

// OpenMesh's readers as a second opinion on well-formed files.
namespace gabarit {
namespace {

namespace om = OpenMesh;

// Receives what OpenMesh's readers find. Attributes other than points and faces are of no interest here.
class FacetImporter final : public om::IO::BaseImporter {
 public:
  om::VertexHandle add_vertex(const om::Vec3f& p) override { return add(Vec3d{p[0], p[1], p[2]}); }
  om::VertexHandle add_vertex(const om::Vec3d& p) override { return add(Vec3d{p[0], p[1], p[2]}); }
  om::VertexHandle add_vertex() override { return add(Vec3d{}); }
  void set_point(om::VertexHandle v, const om::Vec3f& p) override {
    if (inside(v)) points[static_cast<std::size_t>(v.idx())] = Vec3d{p[0], p[1], p[2]};
  }
  om::FaceHandle add_face(const VHandles& corners) override {
    const bool valid = corners.size() >= 3 &&
                       std::all_of(corners.begin(), corners.end(), [this](auto v) { return inside(v); });
    if (!valid) return om::FaceHandle();
    for (const om::VertexHandle v : corners) face_corners.push_back(static_cast<std::uint32_t>(v.idx()));
    face_ends.push_back(face_corners.size());
    return om::FaceHandle(static_cast<int>(face_ends.size() - 1));
  }
  size_t n_vertices() const override { return points.size(); }
  size_t n_faces() const override { return face_ends.size(); }
  size_t n_edges() const override { return 0; }

  om::HalfedgeHandle add_edge(om::VertexHandle, om::VertexHandle) override { return om::HalfedgeHandle(); }
  om::FaceHandle add_face(om::HalfedgeHandle) override { return om::FaceHandle(); }
  void add_face_texcoords(om::FaceHandle, om::VertexHandle, const std::vector<om::Vec2f>&) override {}
  void add_face_texcoords(om::FaceHandle, om::VertexHandle, const std::vector<om::Vec3f>&) override {}
  void set_face_texindex(om::FaceHandle, int) override {}
  void set_halfedge(om::VertexHandle, om::HalfedgeHandle) override {}
  void set_normal(om::VertexHandle, const om::Vec3f&) override {}
  void set_normal(om::VertexHandle, const om::Vec3d&) override {}
  void set_color(om::VertexHandle, const om::Vec3uc&) override {}
  void set_color(om::VertexHandle, const om::Vec4uc&) override {}
  void set_color(om::VertexHandle, const om::Vec3f&) override {}
  void set_color(om::VertexHandle, const om::Vec4f&) override {}
  void set_texcoord(om::VertexHandle, const om::Vec2f&) override {}
  void set_status(om::VertexHandle, const om::Attributes::StatusInfo&) override {}
  void set_next(om::HalfedgeHandle, om::HalfedgeHandle) override {}
  void set_face(om::HalfedgeHandle, om::FaceHandle) override {}
  void request_face_texcoords2D() override {}
  void set_texcoord(om::HalfedgeHandle, const om::Vec2f&) override {}
  void set_texcoord(om::VertexHandle, const om::Vec3f&) override {}
  void set_texcoord(om::HalfedgeHandle, const om::Vec3f&) override {}
  void set_status(om::HalfedgeHandle, const om::Attributes::StatusInfo&) override {}
  void set_color(om::EdgeHandle, const om::Vec3uc&) override {}
  void set_color(om::EdgeHandle, const om::Vec4uc&) override {}
  void set_color(om::EdgeHandle, const om::Vec3f&) override {}
  void set_color(om::EdgeHandle, const om::Vec4f&) override {}
  void set_status(om::EdgeHandle, const om::Attributes::StatusInfo&) override {}
  void set_normal(om::FaceHandle, const om::Vec3f&) override {}
  void set_normal(om::FaceHandle, const om::Vec3d&) override {}
  void set_color(om::FaceHandle, const om::Vec3uc&) override {}
  void set_color(om::FaceHandle, const om::Vec4uc&) override {}
  void set_color(om::FaceHandle, const om::Vec3f&) override {}
  void set_color(om::FaceHandle, const om::Vec4f&) override {}
  void set_status(om::FaceHandle, const om::Attributes::StatusInfo&) override {}
  void add_texture_information(int, std::string) override {}

  std::vector<Vec3d> points;
  std::vector<std::uint32_t> face_corners;
  std::vector<std::size_t> face_ends;  // into face_corners

 private:
  om::VertexHandle add(const Vec3d& p) {
    points.push_back(p);
    return om::VertexHandle(static_cast<int>(points.size() - 1));
  }
  bool inside(om::VertexHandle v) const {
    return v.idx() >= 0 && static_cast<std::size_t>(v.idx()) < points.size();
  }
};

// Triangles over random points with float coordinates: crossing, non-manifold, some of them twice.
shapes::Triangles soup(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto point = [&] {
    return Vec3d{static_cast<double>(random() % 4) + 0.25, static_cast<double>(random() % 4) - 1.5,
                 static_cast<double>(random() % 64)};
  };
  shapes::Triangles triangles;
  while (triangles.size() < 200) {
    const shapes::Triangle t{point(), point(), point()};
    // OpenMesh drops faces with a corner twice.
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
  }
  return triangles;
}

void expect_same_as_openmesh(const std::string& ending, const std::string& bytes) {
  FacetImporter theirs;
  std::istringstream stream(bytes);
  om::IO::Options options;
  ASSERT_TRUE(om::IO::IOManager().read(stream, ending, theirs, options)) << ending;
  const Result<Model> ours = mesh_files::load_bytes("soup" + ending, bytes);
  ASSERT_TRUE(ours) << mesh_files::said(ours);
  ASSERT_EQ(ours->mesh.facet_count(), theirs.n_faces()) << ending;
  for (FacetId f = 0; f < ours->mesh.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(ours->mesh.corner(f, i),
                theirs.points[theirs.face_corners[3 * f + static_cast<std::size_t>(i)]]);
  }
}

TEST(openmesh, reads_the_same_facets_from_random_files) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const shapes::Triangles triangles = soup(seed);
    expect_same_as_openmesh(".obj", mesh_files::obj(triangles));
    expect_same_as_openmesh(".off", mesh_files::off(triangles));
    for (const PlyFormat format : {PlyFormat::ascii, PlyFormat::little_endian, PlyFormat::big_endian})
      expect_same_as_openmesh(".ply", mesh_files::ply(triangles, format));
  }
}

}  // namespace
}  // namespace gabarit
