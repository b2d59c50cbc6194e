// Tyres, rims, spokes, hubs and brake discs.
#include <cmath>
#include <numbers>

#include "examples/motorcycle/groups.h"
#include "examples/motorcycle/solids.h"

namespace gabarit::motorcycle {

namespace {

struct Wheel {
  std::string name;
  double x, radius, half_width;
  Vec3d centre() const { return {x, 0, radius}; }
  Placement axial(double offset = 0) const {
    return stand(centre() + Vec3d{0, offset, 0}, {0, 1, 0}, {1, 0, 0});
  }
};

// The spline starts at its crown, which lies at (2 (r - 14) + 4 (r + 7)) / 6 = r.
Surface tyre(const Wheel& w) {
  const double r = w.radius, shoulder = 0.74 * w.half_width, side = 1.18 * w.half_width,
               bead = 0.74 * w.half_width;
  Surface ring = turned_ring(Outline::spline({{r - 14, -shoulder},
                                              {r + 7, 0},
                                              {r - 14, shoulder},
                                              {r - 58, side},
                                              {r - 98, bead},
                                              {r - 86, 0},
                                              {r - 98, -bead},
                                              {r - 58, -side}}),
                             w.axial());
  ring.smooth_u = true;
  return ring;
}

Surface rim(const Wheel& w) {
  const double r = w.radius - 74, h = 0.78 * w.half_width;
  return turned_ring(Outline::closed({{r - 32, -h + 8, 5},
                                      {r, -h, 3},
                                      {r - 16, -h + 20, 8},
                                      {r - 16, h - 20, 8},
                                      {r, h, 3},
                                      {r - 32, h - 8, 5}}),
                     w.axial());
}

Surface hub(const Wheel& w) {
  const double h = 0.85 * w.half_width;
  return revolved(
      Outline::open({{0, -h}, {30, -h, 3}, {54, -0.25 * h, 12}, {54, 0.25 * h, 12}, {30, h, 3}, {0, h}}),
      w.axial());
}

Surface axle(const Wheel& w, double half_length) {
  return revolved(
      Outline::open({{0, -half_length}, {13, -half_length, 3}, {13, half_length, 3}, {0, half_length}}),
      w.axial());
}

// One arm of a Y; `side` +1 or -1.
Surface spoke(const Wheel& w, double angle, double side) {
  const double rim = w.radius - 98, hub = 40, thickness = 0.55 * w.half_width;
  std::vector<Corner> corners{
      {side * 2, hub, 3}, {side * 24, hub, 3}, {side * 56, rim, 3}, {side * 36, rim, 3}};
  if (side < 0) corners = {corners[1], corners[0], corners[3], corners[2]};
  const Vec3d tangent{-std::sin(angle), 0, std::cos(angle)};
  const Placement place = stand(w.centre() - Vec3d{0, thickness / 2, 0}, {0, 1, 0}, tangent);
  const double middle = side * 30;
  return plate(Outline::closed(corners), thickness, 0, {middle, (rim + hub) / 2}, place);
}

std::vector<Surface> spokes(const Wheel& w) {
  std::vector<Surface> all;
  for (int i = 0; i < 5; ++i) {
    const double angle = std::numbers::pi * (0.5 + 0.4 * i);
    all.push_back(spoke(w, angle, 1)), all.push_back(spoke(w, angle, -1));
  }
  return all;
}

// The braking ring with sharp edges and its carrier.
std::vector<Surface> brake_disc(const Wheel& w, double radius, double y) {
  const auto flat_ring = [&](double from, double to, double thickness) {
    const double h = thickness / 2;
    return turned_ring(Outline::closed({{from, -h}, {to, -h}, {to, h}, {from, h}}), w.axial(y));
  };
  return {flat_ring(radius - 40, radius, 5), flat_ring(34, radius - 38, 3)};
}

}  // namespace

void add_wheels(Parts& parts) {
  const Wheel front{"front", 0, front_wheel_radius, 60}, rear{"rear", wheelbase, rear_wheel_radius, 88};
  parts.push_back({"front tyre", Expectation::round, 26.5, "shoulder", {tyre(front)}});
  parts.push_back({"rear tyre", Expectation::out_of_reach, 23, "shoulder", {tyre(rear)}});
  for (const Wheel& w : {front, rear}) {
    parts.push_back({w.name + " rim", Expectation::out_of_reach, 3, "flange", {rim(w)}});
    parts.push_back({w.name + " spokes", Expectation::out_of_reach, 0, "edges, sharp", spokes(w)});
    parts.push_back({w.name + " hub",
                     Expectation::out_of_reach,
                     3,
                     "ends of the axle",
                     {hub(w), axle(w, w.half_width + 62)}});
  }
  add_pair(parts,
           {"front brake disc", Expectation::out_of_reach, 0, "rim, sharp", brake_disc(front, 150, 70)});
  parts.push_back(
      {"rear brake disc", Expectation::out_of_reach, 0, "rim, sharp", brake_disc(rear, 120, 100)});
}

}  // namespace gabarit::motorcycle
