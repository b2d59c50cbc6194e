// Panniers and their brackets, grab rail, tail light, number plate, rear indicators.
#include "examples/motorcycle/groups.h"
#include "examples/motorcycle/solids.h"

namespace gabarit::motorcycle {

namespace {

// Drawn from the right: x forward, y up, z outward.
Placement on_the_right(const Vec3d& origin, const Vec3d& outward = {0, 1, 0}) {
  return stand(origin, outward, {-1, 0, 0});
}

std::vector<Surface> pannier() {
  const Outline shell = Outline::closed(
      {{235, 150, 90}, {-235, 175, 90}, {-245, -110, 110}, {-120, -185, 120}, {200, -165, 100}});
  const Outline band = Outline::closed(
      {{241, 156, 90}, {-241, 181, 90}, {-251, -113, 110}, {-121, -191, 120}, {205, -171, 100}});
  const Outline latch = Outline::rectangle(90, 34, 12);
  return {plate(shell, 262, 45, {}, on_the_right({1325, 238, 645})),
          plate(band, 16, 6, {}, on_the_right({1325, 330, 645})),
          plate(latch, 22, 8, {}, on_the_right({1325, 326, 810}, {0, 0.35, 1}))};
}

std::vector<Surface> bracket() {
  const Outline outline = Outline::closed({{110, 24}, {-110, 24}, {-80, -24}, {80, -24}});
  const Path tie({{{1240, 120, 700}}, {{1240, 236, 690}}}, {1, 0, 0});
  return {plate(outline, 4, 0, {}, on_the_right({1325, 230, 700})), tube(tie, 9, {})};
}

Surface grab_rail() {
  const Path path({{{1150, 120, 830}},
                   {{1190, 166, 880}, 35},
                   {{1440, 128, 930}, 70},
                   {{1520, 0, 946}, 100},
                   {{1440, -128, 930}, 70},
                   {{1190, -166, 880}, 35},
                   {{1150, -120, 830}}},
                  {0, 0, 1});
  return tube(path, 11, {});
}

Surface tail_light() {
  return rounded_box({104, 40, 30}, 14, 8, stand({1622, 0, 892}, {1, 0, 0.25}, {0, 1, 0}));
}

const Vec3d plate_normal = normalized(Vec3d{0.86, 0, 0.5});  // the number plate faces rearward and up

std::vector<Surface> plate_holder() {
  const Path path({{{1480, 0, 820}}, {{1600, 0, 800}, 60}, {{1702, 0, 650}}}, {0, 1, 0});
  const Placement place = stand(Vec3d{1712, 0, 660} - 3.0 * plate_normal, plate_normal, {0, 1, 0});
  return {swept(path, Outline::rectangle(70, 16, 5), 4), rounded_box({150, 120, 6}, 12, 3, place)};
}

Surface number_plate() {
  return plate(Outline::rectangle(200, 170, 0), 1.5, 0, {}, stand({1712, 0, 655}, plate_normal, {0, 1, 0}));
}

std::vector<Surface> indicator() {
  const Path stem({{{1640, 20, 752}}, {{1650, 120, 756}}}, {0, 0, 1});
  return {tube(stem, 8, {}),
          rounded_box({84, 34, 34}, 14, 8, stand({1652, 152, 757}, {1, 0.1, 0}, {0, 1, 0}))};
}

}  // namespace

void add_rear(Parts& parts) {
  add_pair(parts, {"pannier", Expectation::round, 45, "front edges of the shell", pannier()});
  add_pair(parts, {"pannier bracket", Expectation::out_of_reach, 0, "edges, sharp", bracket()});
  parts.push_back({"grab rail", Expectation::out_of_reach, 0, "ends inside the tail, sharp", {grab_rail()}});
  parts.push_back({"tail light", Expectation::out_of_reach, 8, "edges", {tail_light()}});
  parts.push_back({"plate holder", Expectation::out_of_reach, 3, "edges", plate_holder()});
  parts.push_back({"number plate", Expectation::violates, 0, "edges, sharp", {number_plate()}});
  add_pair(parts, {"rear indicator", Expectation::rear_facing, 8, "edge of the lens", indicator()});
}

}  // namespace gabarit::motorcycle
