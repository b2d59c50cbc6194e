// Faces of any number of corners over a list of points, as OBJ, PLY and OFF files hold them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/model.h"

namespace gabarit {

struct FaceList {
  std::vector<Vec3d> points;            // in the file's unit
  std::vector<std::uint32_t> corners;   // point numbers from 0, face after face
  std::vector<std::size_t> ends;        // of each face, into corners
  std::vector<std::uint32_t> body;      // of each face; empty: all belong to body 0
  std::vector<std::string> body_names;  // empty: one body, called as the file

  void end_face() { ends.push_back(corners.size()); }
  std::size_t face_count() const { return ends.size(); }
};

// Points are numbered by 32 bits.
inline constexpr std::uint64_t most_points = 0xFFFFFFFEU;

// Welds the points and cuts every face of n corners into n - 2 facets, in order, into `model`; corners must
// be in range. Faces of fewer than three corners have no surface: they are counted in a warning. Errors are
// faces of too many corners and more facets than can be numbered.
Diagnostics take_faces(FaceList faces, const std::string& file, double scale, Model& model);

}  // namespace gabarit
