// Handlebar, grips, bar ends, levers and their perches.
#include "examples/motorcycle/groups.h"
#include "examples/motorcycle/solids.h"

namespace gabarit::motorcycle {

namespace {

const Vec3d bar_end{440, 368, 968}, bar_knee{345, 205, 985};
const Vec3d outward = normalized(bar_end - bar_knee);
Vec3d on_bar(double from_end) { return bar_end - from_end * outward; }  // mm inwards from the bar's end

Surface bar() {
  const auto left = [](Vec3d p) { return Vec3d{p.x, -p.y, p.z}; };
  const Vec3d shoulder{268, 92, 902};
  const Path path({{left(bar_end)},
                   {left(bar_knee), 45},
                   {left(shoulder), 45},
                   {shoulder, 45},
                   {bar_knee, 45},
                   {bar_end}},
                  {0, 0, 1});
  return tube(path, 11, {});
}

std::vector<Surface> risers() {
  std::vector<Surface> all;
  for (const double y : {-45.0, 45.0})
    all.push_back(tube(Path({{{252, y, 836}}, {{270, y, 908}}}, {1, 0, 0}), 21, {.first = 4, .last = 6}));
  return all;
}

Surface grip() {
  const Path path({{on_bar(138)}, {on_bar(8)}}, {0, 0, 1});
  return turned_along(
      path, Outline::open(
                {{0, 0}, {21, 0, 5}, {21, 12, 5}, {16.5, 18, 6}, {16.5, 112, 30}, {18, 130, 5}, {0, 130}}));
}

Surface bar_weight() {
  const Path path({{on_bar(6)}, {on_bar(-26)}}, {0, 0, 1});
  return turned_along(path, Outline::open({{0, 0}, {15, 0, 4}, {19, 32, 9}, {0, 32}}));
}

std::vector<Surface> perch() {
  const Placement place = stand(on_bar(168) + Vec3d{-14, 0, 0}, outward, {1, 0, 0});
  const Surface reservoir = revolved(Outline::open({{0, 0}, {26, 0, 6}, {28, 40, 6}, {0, 40}}),
                                     stand(on_bar(200) + Vec3d{-34, 0, 8}, {0.1, 0, 1}, {1, 0, 0}));
  return {rounded_box({64, 40, 46}, 12, 6, place), reservoir};
}

// From its pivot outwards in front of the grip.
Path lever_path() {
  const Vec3d ahead{-62, 0, -6};
  return Path({{on_bar(172) + Vec3d{-38, 0, -4}},
               {on_bar(140) + ahead, 30},
               {on_bar(30) + ahead, 60},
               {on_bar(-22) + ahead + Vec3d{10, 0, 0}}},
              {0, 0, 1});
}

Surface ball_lever() {
  const Path path = lever_path();
  const double end = path.length();
  return turned_along(path, Outline::open({{0, 0},
                                           {7, 0, 5},
                                           {7, 30, 40},
                                           {5.5, 60, 40},
                                           {5.5, end - 18, 6},
                                           {8, end - 12, 8},
                                           {8, end, 8},
                                           {0, end}}));
}

Surface bare_lever() {
  const Path path = lever_path();
  const double end = path.length();
  return turned_along(
      path, Outline::open(
                {{0, 0}, {7, 0, 5}, {7, 30, 40}, {5.5, 60, 40}, {5, end - 40, 60}, {2, end, 2}, {0, end}}));
}

}  // namespace

void add_handlebar(Parts& parts) {
  parts.push_back({"handlebar", Expectation::out_of_reach, 0, "ends inside the weights, sharp", {bar()}});
  parts.push_back({"handlebar risers", Expectation::out_of_reach, 4, "lower edge", risers()});
  add_pair(parts, {"grip", Expectation::out_of_reach, 5, "flange", {grip()}});
  add_pair(parts, {"bar end", Expectation::round, 9, "edge", {bar_weight()}});
  add_pair(parts, {"lever perch", Expectation::out_of_reach, 6, "edges", perch()});
  parts.push_back({"brake lever", Expectation::violates, 2, "tip", {bare_lever()}});
  parts.push_back({"clutch lever", Expectation::round, 8, "ball end", {mirrored(ball_lever())}});
}

}  // namespace gabarit::motorcycle
