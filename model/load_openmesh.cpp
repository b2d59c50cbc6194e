#include "model/load_openmesh.h"

#include <sstream>

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <fmt/format.h>

#include "model/announced.h"
#include "model/polygon.h"
#include "model/text_encoding.h"
#include "model/weld.h"

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
    if (!valid) {
      ++faces_refused;
      return om::FaceHandle();
    }
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
  std::uint64_t faces_refused = 0;

 private:
  om::VertexHandle add(const Vec3d& p) {
    points.push_back(p);
    return om::VertexHandle(static_cast<int>(points.size() - 1));
  }
  bool inside(om::VertexHandle v) const {
    return v.idx() >= 0 && static_cast<std::size_t>(v.idx()) < points.size();
  }
};

// What the reader had to say, instead of printing it.
class QuietReader {
 public:
  QuietReader() {
    ::omerr().connect(text_), ::omerr().disconnect(std::cerr), ::omlog().disconnect(std::clog);
  }
  ~QuietReader() { ::omerr().disconnect(text_), ::omerr().connect(std::cerr), ::omlog().connect(std::clog); }
  QuietReader(const QuietReader&) = delete;
  QuietReader& operator=(const QuietReader&) = delete;
  std::string first_line() const { return valid_utf8(text_.str().substr(0, text_.str().find('\n'))); }

 private:
  std::ostringstream text_;
};

void take_facets(const FacetImporter& read, const Announced& announced, double scale, Model& model) {
  std::vector<VertexId> welded(read.points.size());
  std::vector<Vec3d> points = read.points;
  for (Vec3d& p : points) p *= scale;
  VertexWeld(model.mesh.vertices, points.size()).add(points, welded.data());
  std::size_t polygons = 0;
  std::vector<Vec3d> ring;
  for (std::size_t face = 0, begin = 0; face < read.face_ends.size(); begin = read.face_ends[face++]) {
    const std::span corners(read.face_corners.data() + begin, read.face_ends[face] - begin);
    ring.clear();
    for (const std::uint32_t v : corners) ring.push_back(points[v]);
    polygons += corners.size() > 3;
    for (const auto& [a, b, c] : triangulate(ring)) {
      model.mesh.facets.push_back({welded[corners[a]], welded[corners[b]], welded[corners[c]]});
      if (announced.bodies.size() > 1) model.mesh.body.push_back(announced.face_body[face]);
    }
  }
  if (polygons > 0) {
    model.warnings.push_back(
        {.level = Diagnostic::Level::note,
         .file = model.file,
         .message = fmt::format("{} faces with more than three corners were cut into triangles", polygons)});
  }
}

}  // namespace

Diagnostics load_openmesh(const std::filesystem::path& file, std::string_view bytes,
                          const std::string& ending, double scale, Model& model) {
  const std::string name = file.string();
  Result<Announced> announced = ending == ".ply"   ? announced_ply(bytes, name)
                                : ending == ".off" ? announced_off(bytes, name)
                                                   : Result<Announced>(announced_obj(bytes));
  if (!announced) return announced.error();
  FacetImporter importer;
  const QuietReader quiet;
  // The manager picks the reader by the file's ending, which may be wrong or upper case: the stream form
  // takes ours.
  std::istringstream stream{std::string(bytes)};
  om::IO::Options options;
  const bool read = om::IO::IOManager().read(stream, ending, importer, options);
  const std::uint64_t faces = importer.n_faces();
  if (!read || importer.faces_refused > 0 || faces != announced->faces) {
    const std::string said = quiet.first_line();  // the reader's own words
    return {{.file = name,
             .message = fmt::format("the file announces {} faces, {} could be read{}{}; it is damaged or in "
                                    "a dialect that is not understood: export it again",
                                    announced->faces, faces, said.empty() ? "" : "; ", said)}};
  }
  model.format = ending == ".ply" ? "PLY" : ending == ".off" ? "OFF" : "OBJ";
  model.bodies = announced->bodies;
  if (model.bodies.empty()) model.bodies = {file.stem().string()};
  take_facets(importer, *announced, scale, model);
  return {};
}

}  // namespace gabarit
