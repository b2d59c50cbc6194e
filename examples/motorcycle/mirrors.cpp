// Mirrors on stalks, front indicators.
#include "examples/motorcycle/groups.h"
#include "examples/motorcycle/solids.h"

namespace gabarit::motorcycle {

namespace {

const Vec3d head{258, 352, 1092};  // the middle of the glass, which faces rearward

// A housing whose rim is rounded by `rim`: the glass, the rim of twice that height, a dome towards the front.
Surface housing(double rim) {
  const Outline outline =
      Outline::spline({{-74, -46}, {0, -62}, {84, -52}, {104, 0}, {84, 58}, {0, 60}, {-72, 44}, {-92, 0}});
  const double top = 2 * rim;
  const Outline profile = Outline::open(
      {{rim, 0}, {0, 0, rim}, {0, top, rim}, {rim + 2, top + 1, 1}, {24, top + 20, 16}, {36, top + 20}});
  return prism(outline, profile, {}, stand(head, {-1, 0.12, 0.05}, {0, 1, 0}));
}

Surface stalk() {
  const Path path(
      {{{322, 228, 985}}, {{292, 268, 1040}, 30}, {{264, 318, 1084}, 20}, {head + Vec3d{-10, 0, 0}}},
      {1, 0, 0});
  return tube(path, 7, {.first = 2, .last = 2});
}

std::vector<Surface> indicator(double edge) {
  const Path stem({{{96, 180, 792}}, {{96, 262, 800}}}, {1, 0, 0});
  const Outline outline = Outline::rectangle(84, 36, 15);
  const Placement place = stand({98, 282, 802}, {-1, 0.25, 0}, {0.25, 1, 0});
  const Placement middle = [=](const Vec3d& p) { return place(p - Vec3d{0, 0, 14}); };
  return {tube(stem, 9, {}), plate(outline, 28, edge, {}, middle)};
}

}  // namespace

void add_mirrors(Parts& parts) {
  parts.push_back({"mirror, right", Expectation::round, 6, "rim", {housing(6)}});
  parts.push_back({"mirror, left", Expectation::violates, 3, "rim", {mirrored(housing(3))}});
  add_pair(parts, {"mirror stalk", Expectation::out_of_reach, 2, "ends inside the housing", {stalk()}});
  add_pair(parts, {"front indicator", Expectation::violates, 3.5, "edge of the lens", indicator(3.5)});
}

}  // namespace gabarit::motorcycle
