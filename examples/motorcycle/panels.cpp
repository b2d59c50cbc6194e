// Sheet parts: side fairings, screen, headlights.
#include <limits>

#include "examples/motorcycle/groups.h"
#include "examples/motorcycle/solids.h"

namespace gabarit::motorcycle {

namespace {

// Drawn from the right: x forward, y up, z outward.
Placement on_the_right(const Vec3d& origin, const Vec3d& outward = {0, 1, 0}) {
  return stand(origin, outward, {-1, 0, 0});
}

Surface side_fairing() {
  const Outline outline = Outline::closed({{330, 150, 26},
                                           {40, 205, 160},
                                           {-345, 128, 16},
                                           {-170, 20, 90},
                                           {-120, -180, 50},
                                           {-250, -285, 16},
                                           {40, -300, 120},
                                           {190, -130, 120}});
  const Placement bent =
      placed(draped(-1 / 1400.0, -1 / 620.0, 0), on_the_right({455, 232, 610}, {-0.03, 1, -0.06}));
  return plate(outline, 10, 5, {45, -75}, bent);
}

Surface screen() {
  const Outline outline = Outline::spline({{-212, 0},
                                           {-190, -50},
                                           {0, -60},
                                           {190, -50},
                                           {212, 0},
                                           {196, 140},
                                           {172, 280},
                                           {96, 328},
                                           {0, 338},
                                           {-96, 328},
                                           {-172, 280},
                                           {-196, 140}});
  const Vec3d forward = normalized(Vec3d{-0.70, 0, 0.71});
  const Placement upright = stand(Vec3d{84, 0, 900} - 230.0 * forward, forward, {0, -1, 0});
  return plate(outline, 4, 1, {0, 120},
               placed(barrel(230, std::numeric_limits<double>::infinity()), upright));
}

// The lens, let into the nose.
Surface headlight() {
  const Outline outline =
      Outline::spline({{-80, -10}, {-38, -38}, {44, -36}, {82, 4}, {74, 36}, {16, 32}, {-50, 22}});
  const Placement bent = placed(draped(-1 / 320.0, -1 / 100.0, 0),
                                stand({-46, 114, 764}, {-0.83, 0.54, 0.10}, {0.54, 0.84, 0.05}));
  return plate(outline, 14, 6, {6, 0}, bent);
}

}  // namespace

void add_panels(Parts& parts) {
  add_pair(parts, {"side fairing", Expectation::out_of_reach, 4.5, "edge", {side_fairing()}});
  parts.push_back({"screen", Expectation::out_of_reach, 1, "edge", {screen()}});
  add_pair(parts, {"headlight", Expectation::round, 5.2, "edge", {headlight()}});
}

}  // namespace gabarit::motorcycle
