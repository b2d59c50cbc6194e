// Foot pegs, pedals, side stand, engine guards.
#include "examples/motorcycle/groups.h"
#include "examples/motorcycle/solids.h"

namespace gabarit::motorcycle {

namespace {

std::vector<Surface> peg() {
  const Path rod({{{822, 168, 342}}, {{830, 312, 348}}}, {0, 0, 1});
  const Path arm({{{856, 150, 470}}, {{830, 186, 344}}}, {0, 1, 0});
  return {tube(rod, 13, {.last = 13}), swept(arm, Outline::rectangle(14, 44, 6), 5)};
}

Surface heel_guard() {
  const Outline outline = Outline::closed({{-40, -60, 10}, {50, -70, 20}, {60, 60, 30}, {-20, 80, 20}});
  return plate(outline, 3, 0, {}, stand({890, 172, 400}, {0, 1, 0}, {1, 0, 0}));
}

// The toe piece is a rod of radius 3.5 with a hemispherical end.
std::vector<Surface> gear_lever() {
  const Path arm({{{800, -176, 320}}, {{722, -200, 316}, 20}, {{704, -206, 330}}}, {0, 0, 1});
  const Path toe({{{710, -194, 326}}, {{706, -300, 330}}}, {0, 0, 1});
  return {tube(arm, 6, {.first = 4, .last = 4}), tube(toe, 3.5, {.first = 3.5, .last = 3.5})};
}

std::vector<Surface> brake_pedal() {
  const Path arm({{{800, 176, 310}}, {{728, 204, 304}, 20}, {{708, 236, 316}}}, {0, 0, 1});
  const Surface pad =
      plate(Outline::rectangle(46, 76, 12), 12, 1.5, {}, stand({704, 258, 318}, {-0.15, 0, 1}, {1, 0, 0}));
  return {tube(arm, 8, {.first = 4, .last = 4}), pad};
}

// Folded up: the leg lies along the vehicle, its foot stands out with sharp plate edges.
std::vector<Surface> side_stand() {
  const Path leg({{{690, -158, 250}}, {{905, -232, 176}}}, {0, 1, 0});
  const Surface foot =
      plate(Outline::rectangle(74, 52, 0), 5, 0, {}, stand({925, -240, 170}, {-0.2, -0.55, 0.8}, {1, 0, 0}));
  return {tube(leg, 12, {.first = 4, .last = 4}), foot};
}

Surface guard() {
  const Path path({{{450, 150, 600}}, {{490, 330, 566}, 70}, {{516, 334, 372}, 70}, {{540, 140, 330}}},
                  {1, 0, 0});
  return tube(path, 13, {});
}

}  // namespace

void add_footrests(Parts& parts) {
  add_pair(parts, {"foot peg", Expectation::round, 13, "outer end", peg()});
  add_pair(parts, {"heel guard", Expectation::out_of_reach, 0, "edges, sharp", {heel_guard()}});
  parts.push_back({"gear lever", Expectation::violates, 3.5, "outer end of the toe piece", gear_lever()});
  parts.push_back({"brake pedal", Expectation::violates, 1.5, "edge of the pad", brake_pedal()});
  parts.push_back({"side stand", Expectation::violates, 0, "foot, sharp plate", side_stand()});
  add_pair(parts, {"engine guard", Expectation::rear_facing, 13, "tube", {guard()}});
}

}  // namespace gabarit::motorcycle
