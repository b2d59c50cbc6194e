#include "model/face_list.h"

#include <filesystem>

#include <fmt/format.h>

#include "model/polygon.h"
#include "model/text_encoding.h"
#include "model/weld.h"

namespace gabarit {
namespace {

// Cutting takes time with the square of the corners at worst; no part has a face like this.
constexpr std::size_t most_corners = 65'536;

struct Sizes {
  std::uint64_t facets = 0, polygons = 0, without_surface = 0;
};

Diagnostics measure(const FaceList& faces, const std::string& file, Sizes& sizes) {
  std::size_t begin = 0;
  for (std::size_t face = 0; face < faces.face_count(); begin = faces.ends[face++]) {
    const std::size_t n = faces.ends[face] - begin;
    if (n > most_corners) {
      return {{.file = file,
               .message = fmt::format("face {} has {} corners, more than {}; export it in triangles",
                                      face + 1, n, most_corners)}};
    }
    sizes.polygons += n > 3;
    sizes.without_surface += n < 3;
    sizes.facets += n < 3 ? 0 : n - 2;
  }
  if (sizes.facets > most_facets || faces.points.size() > most_points) {
    return {{.file = file,
             .message = fmt::format("has {} facets and {} points, more than can be numbered; split the model",
                                    sizes.facets, faces.points.size())}};
  }
  return {};
}

void tell(const Sizes& sizes, const std::string& file, Model& model) {
  const auto add = [&](Diagnostic::Level level, std::string message) {
    model.warnings.push_back({.level = level, .file = file, .message = std::move(message)});
  };
  if (sizes.polygons > 0) {
    add(Diagnostic::Level::note,
        fmt::format("{} faces with more than three corners were cut into triangles", sizes.polygons));
  }
  if (sizes.without_surface > 0) {
    add(Diagnostic::Level::warning,
        fmt::format("{} faces with fewer than three corners have no surface and were left out",
                    sizes.without_surface));
  }
}

}  // namespace

Diagnostics take_faces(FaceList faces, const std::string& file, double scale, Model& model) {
  Sizes sizes;
  if (Diagnostics errors = measure(faces, file, sizes); !errors.empty()) return errors;
  for (Vec3d& p : faces.points) p *= scale;
  std::vector<VertexId> welded(faces.points.size());
  VertexWeld(model.mesh.vertices, faces.points.size()).add(faces.points, welded.data());
  TriangleMesh& mesh = model.mesh;
  mesh.facets.reserve(sizes.facets);
  std::vector<Vec3d> ring;
  std::size_t begin = 0;
  for (std::size_t face = 0; face < faces.face_count(); begin = faces.ends[face++]) {
    const std::span corners(faces.corners.data() + begin, faces.ends[face] - begin);
    ring.clear();
    for (const std::uint32_t v : corners) ring.push_back(faces.points[v]);
    for (const auto& [a, b, c] : triangulate(ring)) {
      mesh.facets.push_back({welded[corners[a]], welded[corners[b]], welded[corners[c]]});
      if (faces.body_names.size() > 1) mesh.body.push_back(faces.body[face]);
    }
  }
  model.bodies = std::move(faces.body_names);
  if (model.bodies.empty()) model.bodies = {valid_utf8(std::filesystem::path(file).stem().string())};
  tell(sizes, file, model);
  return {};
}

}  // namespace gabarit
