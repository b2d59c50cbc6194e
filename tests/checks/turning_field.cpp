#include "tests/checks/turning_field.h"

#include <cmath>

#include "checks/turning.h"

namespace gabarit {

Field measured(const TriangleMesh& mesh, double sag, const Region& region, int threads) {
  Model model;
  model.bodies = {"part"};
  model.mesh = mesh;
  Setup setup;
  setup.sag = sag;
  return measure_turning(Scene(model, Device::cpu(threads)), setup, region);
}

Field measured(const shapes::Triangles& triangles, double sag) {
  const TriangleMesh mesh = shapes::mesh(triangles);
  return measured(mesh, sag, whole_model(mesh));
}

shapes::Triangles roof(double turn, double width, double length) {
  const double c = std::cos(turn / 2) * width, s = std::sin(turn / 2) * width;
  const Vec3d a{0, 0, 0}, b{0, length, 0}, p{-c, 0, -s}, q{-c, length, -s}, u{c, 0, -s}, v{c, length, -s};
  return {{p, a, b}, {p, b, q}, {a, u, v}, {a, v, b}};
}

}  // namespace gabarit
