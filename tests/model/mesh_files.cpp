#include "tests/model/mesh_files.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "tests/temporary_folder.h"

namespace gabarit::mesh_files {

template <class T>
static std::string bytes_of(T value, bool reversed = false) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (reversed) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

static std::string numbers(const Vec3d& p) { return fmt::format("{} {} {}", p.x, p.y, p.z); }

std::string binary_stl(const shapes::Triangles& triangles) {
  std::string bytes(80, ' ');
  bytes += bytes_of(static_cast<std::uint32_t>(triangles.size()));
  for (const auto& triangle : triangles) {
    bytes += std::string(12, '\0');
    for (const Vec3d& p : triangle) {
      for (int axis = 0; axis < 3; ++axis) bytes += bytes_of(static_cast<float>(p[axis]));
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string ascii_stl(const shapes::Triangles& triangles, const std::string& line_end,
                      const std::string& name) {
  std::string text = "solid " + name + line_end;
  for (const auto& [a, b, c] : triangles) {
    for (const std::string& line :
         {std::string("facet normal 0 0 0"), std::string("  outer loop"), "    vertex " + numbers(a),
          "    vertex " + numbers(b), "    vertex " + numbers(c), std::string("  endloop"),
          std::string("endfacet")})
      text += line + line_end;
  }
  return text + "endsolid " + name + line_end;
}

std::string obj(const shapes::Triangles& triangles) {
  const TriangleMesh mesh = shapes::mesh(triangles);
  std::string text = "# a part\n";
  for (const Vec3d& p : mesh.vertices) text += "v " + numbers(p) + '\n';
  for (const auto& [a, b, c] : mesh.facets) text += fmt::format("f {} {} {}\n", a + 1, b + 1, c + 1);
  return text;
}

std::string ply(const shapes::Triangles& triangles, PlyFormat format) {
  const TriangleMesh mesh = shapes::mesh(triangles);
  const bool big = format == PlyFormat::big_endian;
  const char* const name = format == PlyFormat::ascii ? "ascii"
                           : big                      ? "binary_big_endian"
                                                      : "binary_little_endian";
  std::string text = fmt::format(
      "ply\nformat {} 1.0\ncomment a part\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      name, mesh.vertices.size(), mesh.facet_count());
  for (const Vec3d& p : mesh.vertices) {
    if (format == PlyFormat::ascii) {
      text += numbers(p) + '\n';
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) text += bytes_of(p[axis], big);
  }
  for (const auto& facet : mesh.facets) {
    if (format == PlyFormat::ascii) {
      text += fmt::format("3 {} {} {}\n", facet[0], facet[1], facet[2]);
      continue;
    }
    text += '\3';
    for (const VertexId v : facet) text += bytes_of(static_cast<std::int32_t>(v), big);
  }
  return text;
}

std::string off(const shapes::Triangles& triangles) {
  const TriangleMesh mesh = shapes::mesh(triangles);
  std::string text = fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.facet_count());
  for (const Vec3d& p : mesh.vertices) text += numbers(p) + '\n';
  for (const auto& [a, b, c] : mesh.facets) text += fmt::format("3 {} {} {}\n", a, b, c);
  return text;
}

Result<Model> load_bytes(const std::string& file_name, const std::string& bytes, const LoadOptions& options) {
  const TemporaryFolder folder;
  put(folder / file_name, bytes);
  return load(folder / file_name, options);
}

std::string said(const Result<Model>& result) {
  std::string text;
  for (const Diagnostic& d : result ? result->warnings : result.error()) text += to_string(d);
  return text;
}

shapes::Triangles corners(const Model& model) {
  shapes::Triangles triangles;
  for (FacetId f = 0; f < model.mesh.facet_count(); ++f) triangles.push_back(model.mesh.corners(f));
  return triangles;
}

}  // namespace gabarit::mesh_files
