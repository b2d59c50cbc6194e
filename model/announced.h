// What a mesh file says it holds, read before anything is allocated for it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/result.h"

namespace gabarit {

struct Announced {
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  std::vector<std::string> bodies;       // names of an OBJ file's objects and groups that have faces
  std::vector<std::uint32_t> face_body;  // of each face, when there is more than one body
};

// Reads the header (PLY, OFF) or counts the lines (OBJ); refuses counts that the file is too short for.
Result<Announced> announced_ply(std::string_view bytes, const std::string& name);
Result<Announced> announced_off(std::string_view bytes, const std::string& name);
Announced announced_obj(std::string_view bytes);

}  // namespace gabarit
