// Frame, gussets, swing arm, chain, subframe.
#include "examples/motorcycle/groups.h"
#include "examples/motorcycle/solids.h"

namespace gabarit::motorcycle {

namespace {

Surface spar() {
  const Path path({{{268, 34, 760}}, {{400, 150, 748}, 90}, {{770, 168, 590}, 120}, {{862, 150, 370}}},
                  {0, 1, 0});
  return swept(path, Outline::rectangle(38, 84, 10), 0);
}

Surface gusset() {
  const Outline outline = Outline::closed({{0, 0}, {120, -10}, {30, 110}});
  return plate(outline, 4, 0, {50, 33}, stand({300, 60, 640}, {0, -1, 0}, {1, 0, 0}));
}

std::vector<Surface> swing_arm() {
  std::vector<Surface> all;
  const Path path({{{860, 120, 400}}, {{1130, 138, 352}, 300}, {{1450, 132, 312}}}, {0, 1, 0});
  const Surface arm = swept(path, Outline::rectangle(34, 72, 12), 6);
  const Path cross({{{1010, -128, 378}}, {{1010, 128, 378}}}, {1, 0, 0});
  const Path pivot({{{868, -160, 398}}, {{868, 160, 398}}}, {1, 0, 0});
  return {arm, mirrored(arm), tube(cross, 34, {}), tube(pivot, 20, {.first = 3, .last = 3})};
}

std::vector<Surface> chain() {
  const auto sprocket = [](double x, double z, double radius) {
    return revolved(Outline::open({{0, -4}, {radius, -4}, {radius, 4}, {0, 4}}),
                    stand({x, -112, z}, {0, 1, 0}, {1, 0, 0}));
  };
  const auto run = [](Vec3d from, Vec3d to) {
    return swept(Path({{from}, {to}}, {0, 1, 0}), Outline::rectangle(16, 14, 3), 0);
  };
  return {sprocket(wheelbase, rear_wheel_radius, 104), sprocket(800, 420, 38),
          run({800, -112, 458}, {1416, -112, 419}), run({800, -112, 382}, {1416, -112, 211})};
}

std::vector<Surface> subframe() {
  std::vector<Surface> all;
  const Path rail({{{700, 120, 730}}, {{960, 112, 728}, 120}, {{1440, 84, 842}}}, {0, 1, 0});
  const Path strut({{{850, 140, 520}}, {{1300, 96, 806}}}, {0, 1, 0});
  for (const Path& path : {rail, strut}) {
    const Surface right = tube(path, 12, {});
    all.push_back(right), all.push_back(mirrored(right));
  }
  return all;
}

std::vector<Surface> shock() {
  const Path line({{{880, 0, 360}}, {{812, 0, 690}}}, {0, 1, 0});
  const Surface bellows = turned_along(line, Outline::open({{0, 70},
                                                            {44, 70, 6},
                                                            {34, 110, 6},
                                                            {44, 150, 6},
                                                            {34, 190, 6},
                                                            {44, 230, 6},
                                                            {34, 270, 6},
                                                            {44, 300, 6},
                                                            {0, 300}}));
  return {tube(line, 18, {.first = 4, .last = 4}), bellows};
}

}  // namespace

void add_chassis(Parts& parts) {
  add_pair(parts, {"frame spar", Expectation::out_of_reach, 0, "ends, sharp", {spar()}});
  add_pair(parts, {"frame gusset", Expectation::out_of_reach, 0, "edges, sharp", {gusset()}});
  parts.push_back({"swing arm", Expectation::out_of_reach, 0, "cross tube's ends, sharp", swing_arm()});
  parts.push_back({"chain and sprockets", Expectation::out_of_reach, 0, "edges, sharp", chain()});
  parts.push_back({"subframe", Expectation::out_of_reach, 0, "tube ends, sharp", subframe()});
  parts.push_back({"rear shock", Expectation::out_of_reach, 4, "ends", shock()});
}

}  // namespace gabarit::motorcycle
