// Crankcase, cylinders with fins, covers, radiator, exhaust.
#include "examples/motorcycle/groups.h"
#include "examples/motorcycle/solids.h"

namespace gabarit::motorcycle {

namespace {

const Vec3d bore = normalized(Vec3d{-0.34, 0, 0.94});  // the cylinders lean forward

Surface crankcase() {
  return rounded_box({430, 300, 220}, 70, 20, stand({646, 0, 418}, {0, 0, 1}, {1, 0, 0.1}));
}

Surface cover(double x, double z, double radius, double height) {
  return revolved(
      Outline::open(
          {{0, 0}, {radius, 0}, {radius, height - 14, 6}, {0.78 * radius, height, 20}, {0, height}}),
      stand({x, 146, z}, {0, 1, 0}, {1, 0, 0}));
}

std::vector<Surface> cylinders() {
  const Vec3d base{540, 0, 510};
  const Surface barrel_block =
      rounded_box({150, 330, 150}, 24, 8, stand(base + 50.0 * bore, bore, {1, 0, 0}));
  const Surface head = rounded_box({190, 350, 90}, 30, 14, stand(base + 165.0 * bore, bore, {1, 0, 0}));
  return {barrel_block, head};
}

std::vector<Surface> fins() {
  std::vector<Surface> all;
  for (int i = 0; i < 5; ++i) {
    const Vec3d at = Vec3d{540, 0, 510} + (14.0 + 20 * i) * bore;
    all.push_back(plate(Outline::rectangle(176, 356, 26), 3, 0, {}, stand(at, bore, {1, 0, 0})));
  }
  return all;
}

Surface radiator() {
  return rounded_box({340, 256, 40}, 12, 4, stand({352, 0, 520}, {-1, 0, -0.18}, {0, 1, 0}));
}

std::vector<Surface> headers() {
  std::vector<Surface> all;
  for (const double y : {-62.0, 62.0}) {
    const double low = 0.55 * y;
    const Path path({{{450, y, 600}},
                     {{385, y, 580}, 60},
                     {{352, y, 300}, 70},
                     {{470, low, 215}, 80},
                     {{820, 0.4 * y + 60, 226}}},
                    {0, 1, 0});
    all.push_back(tube(path, 19, {}));
  }
  return all;
}

std::vector<Surface> silencer() {
  const Path link({{{780, 60, 226}}, {{930, 120, 236}, 90}, {{1060, 196, 318}}}, {0, 1, 0});
  const Path body({{{1010, 178, 296}}, {{1440, 226, 442}}}, {0, 1, 0});
  const double end = body.length();
  const Surface can =
      turned_along(body, Outline::open({{0, 0}, {30, 0, 8}, {58, 60, 50}, {58, end, 14}, {0, end}}));
  const Vec3d along = normalized(Vec3d{430, 48, 146});
  const Surface outlet = turned_ring(Outline::closed({{26, -30}, {30, -30}, {30, 22}, {26, 22}}),
                                     stand({1440, 226, 442}, along, {1, 0, 0}));
  return {tube(link, 25, {}), can, outlet};
}

}  // namespace

void add_engine(Parts& parts) {
  parts.push_back({"crankcase", Expectation::out_of_reach, 20, "edges", {crankcase()}});
  add_pair(parts,
           {"engine cover", Expectation::out_of_reach, 0, "inner edge, sharp", {cover(606, 412, 88, 46)}});
  parts.push_back({"cylinders", Expectation::out_of_reach, 8, "edges", cylinders()});
  parts.push_back({"cylinder fins", Expectation::out_of_reach, 0, "edges, sharp", fins()});
  parts.push_back({"radiator", Expectation::out_of_reach, 4, "edges", {radiator()}});
  parts.push_back({"exhaust headers", Expectation::out_of_reach, 0, "ends, sharp", headers()});
  parts.push_back({"silencer", Expectation::out_of_reach, 0, "outlet, sharp", silencer()});
}

}  // namespace gabarit::motorcycle
