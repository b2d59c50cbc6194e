// Fork, triple clamps, brake calipers, front mudguard.
#include <limits>

#include "examples/motorcycle/groups.h"
#include "examples/motorcycle/solids.h"

namespace gabarit::motorcycle {

namespace {

const Vec3d rake = normalized(Vec3d{0.42, 0, 0.9});  // up along the fork
const Vec3d foot{-18, 0, 268};                       // the lower end of the fork's axis, in the middle
constexpr double track = 108;                        // of a fork leg from the middle

Vec3d on_fork(double up, double y) { return foot + up * rake + Vec3d{0, y, 0}; }

std::vector<Surface> fork_leg() {
  const auto straight = [](double from, double to) {
    return Path({{on_fork(from, track)}, {on_fork(to, track)}}, {1, 0, 0});
  };
  const Surface clamp = rounded_box({58, 46, 76}, 12, 6, stand({2, track, 300}, rake, {1, 0, 0}));
  const Path stanchion = straight(20, 300), outer = straight(225, 650);
  const Surface collar = tube(straight(222, 262), 31, {.first = 5, .last = 5});
  return {tube(stanchion, 21, {}), tube(outer, 27, {.first = 6, .last = 6}), collar, clamp};
}

Surface triple_clamp(double up, double thickness) {
  const Outline outline = Outline::closed({{-track - 38, -34, 33},
                                           {-30, -48, 40},
                                           {30, -48, 40},
                                           {track + 38, -34, 33},
                                           {track + 38, 34, 33},
                                           {-track - 38, 34, 33}});
  return plate(outline, thickness, 5, {}, stand(on_fork(up, 0), rake, {0, 1, 0}));
}

std::vector<Surface> caliper() {
  const Placement place = stand({88, 84, 385}, {0.75, 0, 0.66}, {0, 1, 0});
  const Surface bolt = tube(Path({{{60, 70, 372}}, {{60, 112, 372}}}, {1, 0, 0}), 8, {.first = 2, .last = 2});
  return {rounded_box({50, 62, 118}, 14, 8, place), bolt};
}

// Around the tyre from 42° before its top to 70° behind it.
Surface mudguard() {
  const Outline outline = Outline::closed({{-235, -36, 30},
                                           {-150, -102, 70},
                                           {90, -112, 80},
                                           {220, -80, 80},
                                           {300, -62, 40},
                                           {300, 62, 40},
                                           {220, 80, 80},
                                           {90, 112, 80},
                                           {-150, 102, 70},
                                           {-235, 36, 30}});
  const Placement around = stand({0, 0, front_wheel_radius}, {0, 0, 1}, {1, 0, 0});
  return plate(outline, 13, 6.5, {}, placed(barrel(front_wheel_radius + 14, 86), around));
}

Surface mudguard_stay() {
  const Outline outline = Outline::closed({{-46, -18, 10}, {40, -30, 10}, {62, 26, 14}, {-30, 34, 14}});
  return plate(outline, 6, 0, {}, stand({60, 76, 520}, {0, 1, 0}, {1, 0, 0}));
}

// On the outer side of the fork's foot.
Surface reflector() {
  return plate(Outline::rectangle(62, 28, 6), 7, 0, {}, stand({0, track + 22, 300}, {0, 1, 0}, {1, 0, 0}));
}

}  // namespace

void add_front_end(Parts& parts) {
  add_pair(parts,
           {"fork leg", Expectation::out_of_reach, 0, "lower end of the stanchion, sharp", fork_leg()});
  add_pair(parts, {"fork reflector", Expectation::out_of_reach, 0, "edges, sharp", {reflector()}});
  parts.push_back({"triple clamps",
                   Expectation::out_of_reach,
                   5,
                   "edges",
                   {triple_clamp(470, 36), triple_clamp(620, 28)}});
  add_pair(parts, {"front caliper", Expectation::out_of_reach, 2, "bolt", caliper()});
  parts.push_back({"front mudguard", Expectation::round, 5.8, "edge", {mudguard()}});
  add_pair(parts, {"mudguard stay", Expectation::out_of_reach, 0, "edges, sharp", {mudguard_stay()}});
}

}  // namespace gabarit::motorcycle
