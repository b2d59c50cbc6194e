// What was loaded: named bodies, facets, and how the file was understood.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gpu/box.h"
#include "model/brep.h"
#include "model/defects.h"
#include "model/result.h"
#include "model/triangle_mesh.h"

namespace gabarit {

enum class Unit { mm, cm, m, in };
double millimetres(Unit unit);  // in one unit
const char* name(Unit unit);
std::optional<Unit> unit_named(const std::string& name);

struct Model {
  std::string file;                 // the file's name without its folder
  std::string format;               // such as "binary STL"
  std::string sha256;               // of the file's bytes, 64 hexadecimal digits
  Unit unit = Unit::mm;             // of the file's coordinates
  bool unit_declared = false;       // by the user or the file; otherwise assumed
  std::optional<double> sag;        // mm, when the user declares it or the facets were made here
  std::vector<std::string> bodies;  // names by body number, UTF-8, never empty strings
  TriangleMesh mesh;
  std::optional<Brep> brep;  // the exact surfaces, when the file had them
  Box3d box;
  Defects defects;
  Diagnostics warnings;  // implausible size, repaired text encodings, …
};

}  // namespace gabarit
