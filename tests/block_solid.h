// Closed parts of any number of facets for tests and benchmarks: cells of a grid, bent by a smooth map.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "model/triangle_mesh.h"

namespace gabarit::shapes {

// The outside of the filled cells. Grid lines ascend; `map` bends the finished solid, keeping its handedness.
struct BlockSolid {
  std::array<std::vector<double>, 3> lines;
  std::function<bool(int, int, int)> filled;  // asked for cells of the grid only
  std::function<Vec3d(const Vec3d&)> map = [](const Vec3d& p) { return p; };
  std::array<double, 3> stretch{1, 1, 1};  // mm a unit of each grid direction, for the size of facets
  bool closed_x = false;                   // the last grid line of x is the first
};

// Two facets a square of about `step` mm; neighbours share vertices.
TriangleMesh surface(const BlockSolid& solid, double step);

// A tray of 200 x 140 x 40 mm with walls and ribs of 2 to 3 mm, slightly domed.
BlockSolid ribbed_casting();
// The same with a draft of 1 degree on the sides of its ribs and walls, as a mould needs.
BlockSolid drafted_casting();
// 80 mm across, 90 mm high, walls of 3 mm, a handle of 8 mm and a small hole in the floor.
BlockSolid cup_with_a_handle();
// 150 x 100 x 80 mm with eight square holes through it.
BlockSolid thick_block_with_holes();

// The step that gives about so many facets, and that surface.
TriangleMesh with_facets(const BlockSolid& solid, double facets);

}  // namespace gabarit::shapes
