#include "tests/block_solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace gabarit::shapes {
namespace {

// Grid lines with the steps between them; `coarse[i]` is the place of line i among the fine ones.
struct FineLines {
  std::vector<double> at;
  std::vector<int> coarse;
};

FineLines refined(const std::vector<double>& lines, double step) {
  FineLines fine{{lines.front()}, {0}};
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const int parts = std::max(1, static_cast<int>(std::lround((lines[i + 1] - lines[i]) / step)));
    for (int k = 1; k <= parts; ++k)
      fine.at.push_back(k == parts ? lines[i + 1] : lines[i] + (lines[i + 1] - lines[i]) * k / parts);
    fine.coarse.push_back(static_cast<int>(fine.at.size()) - 1);
  }
  return fine;
}

class Mesher {
 public:
  Mesher(const BlockSolid& solid, double step) : solid_(solid) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      fine_[axis] = refined(solid.lines[axis], step / solid.stretch[axis]);
  }

  TriangleMesh mesh() {
    for (int axis = 0; axis < 3; ++axis) {
      std::array<int, 3> cell{};
      for (cell[0] = 0; cell[0] < cells(0); ++cell[0])
        for (cell[1] = 0; cell[1] < cells(1); ++cell[1])
          for (cell[2] = 0; cell[2] < cells(2); ++cell[2]) add_sides(cell, axis);
    }
    return std::move(mesh_);
  }

 private:
  int cells(std::size_t axis) const { return static_cast<int>(solid_.lines[axis].size()) - 1; }

  bool filled(std::array<int, 3> cell) const {
    if (solid_.closed_x) cell[0] = (cell[0] + cells(0)) % cells(0);
    for (std::size_t k = 0; k < 3; ++k)
      if (cell[k] < 0 || cell[k] >= cells(k)) return false;
    return solid_.filled(cell[0], cell[1], cell[2]);
  }

  void add_sides(const std::array<int, 3>& cell, int axis) {
    if (!filled(cell)) return;
    const auto a = static_cast<std::size_t>(axis);
    for (const int side : {0, 1}) {
      std::array<int, 3> beside = cell;
      beside[a] += side == 1 ? 1 : -1;
      if (!filled(beside)) add_side(cell, a, side);
    }
  }

  void add_side(const std::array<int, 3>& cell, std::size_t axis, int side) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto from = [&](std::size_t k) { return fine_[k].coarse[static_cast<std::size_t>(cell[k])]; };
    const auto to = [&](std::size_t k) { return fine_[k].coarse[static_cast<std::size_t>(cell[k]) + 1]; };
    std::array<int, 3> p{};
    p[axis] = side == 1 ? to(axis) : from(axis);
    for (p[u] = from(u); p[u] < to(u); ++p[u]) {
      for (p[v] = from(v); p[v] < to(v); ++p[v]) {
        std::array<VertexId, 4> corner{};
        for (std::size_t k = 0; k < 4; ++k) {
          std::array<int, 3> q = p;
          q[u] += k == 1 || k == 2 ? 1 : 0;
          q[v] += k >= 2 ? 1 : 0;
          corner[k] = vertex(q);
        }
        if (side == 0) std::swap(corner[1], corner[3]);
        mesh_.facets.push_back({corner[0], corner[1], corner[2]});
        mesh_.facets.push_back({corner[0], corner[2], corner[3]});
      }
    }
  }

  VertexId vertex(std::array<int, 3> p) {
    if (solid_.closed_x && p[0] == fine_[0].coarse.back()) p[0] = 0;
    const std::uint64_t key = static_cast<std::uint64_t>(p[0]) << 42 |
                              static_cast<std::uint64_t>(p[1]) << 21 | static_cast<std::uint64_t>(p[2]);
    const auto [place, fresh] = known_.try_emplace(key, static_cast<VertexId>(mesh_.vertices.size()));
    if (fresh) {
      const auto at = [&](std::size_t k) { return fine_[k].at[static_cast<std::size_t>(p[k])]; };
      mesh_.vertices.push_back(solid_.map({at(0), at(1), at(2)}));
    }
    return place->second;
  }

  const BlockSolid& solid_;
  std::array<FineLines, 3> fine_;
  std::unordered_map<std::uint64_t, VertexId> known_;
  TriangleMesh mesh_;
};

// Lines at both sides of `count` walls, the first and last at the ends of [0, length].
std::vector<double> walls(double length, int count, double outer, double inner) {
  std::vector<double> lines;
  for (int i = 0; i < count; ++i) {
    const double middle = length * i / (count - 1);
    lines.push_back(i == 0 ? 0 : i == count - 1 ? length - outer : middle - inner / 2);
    lines.push_back(i == 0 ? outer : i == count - 1 ? length : middle + inner / 2);
  }
  return lines;
}

// The place of x when every wall gets thinner upwards by `inset` on both sides and the rooms between grow.
double drafted(const std::vector<double>& lines, double x, double inset) {
  std::size_t i = 0;
  while (i + 2 < lines.size() && x > lines[i + 1]) ++i;
  const auto moved = [&](std::size_t k) { return lines[k] + (k % 2 == 0 ? inset : -inset); };
  const double share = (x - lines[i]) / (lines[i + 1] - lines[i]);
  return moved(i) + share * (moved(i + 1) - moved(i));
}

}  // namespace

TriangleMesh surface(const BlockSolid& solid, double step) { return Mesher(solid, step).mesh(); }

TriangleMesh with_facets(const BlockSolid& solid, double facets) {
  const double coarse = 4;
  const auto count = static_cast<double>(surface(solid, coarse).facet_count());
  double step = coarse * std::sqrt(count / facets);
  // Rounding to whole parts between the lines shifts the count: once more from nearer.
  if (facets > 2000) {
    const double probe = std::max(step, 1.0);
    step = probe * std::sqrt(static_cast<double>(surface(solid, probe).facet_count()) / facets);
  }
  return surface(solid, step);
}

BlockSolid ribbed_casting() {
  BlockSolid solid;
  solid.lines = {{walls(200, 8, 3, 2), walls(140, 6, 3, 2.5), {0, 3, 24, 40}}};
  solid.filled = [nx = static_cast<int>(solid.lines[0].size()) - 1,
                  ny = static_cast<int>(solid.lines[1].size()) - 1](int i, int j, int k) {
    const bool outer = i == 0 || j == 0 || i == nx - 1 || j == ny - 1;
    const bool rib = i % 2 == 0 || j % 2 == 0;
    return k == 0 || outer || (rib && k == 1);
  };
  solid.map = [](const Vec3d& p) {
    const double u = p.x / 200 - 0.5, v = p.y / 140 - 0.5;
    return Vec3d{p.x + 0.02 * p.z * u, p.y + 0.02 * p.z * v, p.z - 12 * u * u - 8 * v * v};
  };
  return solid;
}

BlockSolid drafted_casting() {
  BlockSolid solid = ribbed_casting();
  const double slope = std::tan(std::numbers::pi / 180);
  solid.map = [bend = solid.map, x = solid.lines[0], y = solid.lines[1], slope](const Vec3d& p) {
    return bend({drafted(x, p.x, slope * p.z), drafted(y, p.y, slope * p.z), p.z});
  };
  return solid;
}

BlockSolid cup_with_a_handle() {
  BlockSolid solid;
  std::vector<double> angles;
  for (int i = 0; i <= 36; ++i) angles.push_back(2 * std::numbers::pi * i / 36);
  solid.lines = {{angles, {4, 37, 40, 52, 60}, {0, 3, 18, 26, 66, 74, 90}}};  // angle, radius, height
  solid.filled = [](int angle, int ring, int level) {
    if (ring == 0) return level == 0;
    if (ring == 1) return true;
    if (angle > 1) return false;
    return ring == 3 ? level >= 2 && level <= 4 : level == 2 || level == 4;
  };
  solid.map = [](const Vec3d& p) {
    const double radius = p.y * (1 + 0.0015 * p.z);
    return Vec3d{radius * std::cos(p.x), -radius * std::sin(p.x), p.z};
  };
  solid.stretch = {40, 1, 1};
  solid.closed_x = true;
  return solid;
}

BlockSolid thick_block_with_holes() {
  BlockSolid solid;
  solid.lines = {{{0, 18, 34, 50, 66, 84, 100, 116, 132, 150}, {0, 20, 40, 60, 80, 100}, {0, 80}}};
  solid.filled = [](int i, int j, int) { return i % 2 == 0 || j % 2 == 0; };
  solid.map = [](const Vec3d& p) {
    return Vec3d{p.x, p.y, p.z * (1 + 0.05 * std::sin(p.x / 30) * std::cos(p.y / 25))};
  };
  return solid;
}

}  // namespace gabarit::shapes
