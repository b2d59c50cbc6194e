#include "bench/stand_in.h"

#include <cmath>
#include <functional>
#include <numbers>

#include "model/weld.h"

namespace gabarit {
namespace {

constexpr double pi = std::numbers::pi;

// A surface over the unit square, and about how long its sides are, mm.
struct Patch {
  std::function<Vec3d(double u, double v)> at;
  double along, around;
};

double power(double x, double e) { return std::copysign(std::pow(std::abs(x), e), x); }

// An ellipsoid (roundness 1) or something between it and a box.
Patch blob(Vec3d centre, Vec3d half, double roundness = 1) {
  return {[=](double u, double v) {
            const double a = pi * (u - 0.5), b = 2 * pi * v;
            const double c = power(std::cos(a), roundness);
            return centre + Vec3d{half.x * c * power(std::cos(b), roundness),
                                  half.y * c * power(std::sin(b), roundness),
                                  half.z * power(std::sin(a), roundness)};
          },
          2 * (half.z + std::max(half.x, half.y)), 2 * pi * std::max(half.x, half.y)};
}

// A ring in the plane y = centre.y.
Patch ring(Vec3d centre, double radius, double tube) {
  return {[=](double u, double v) {
            const double a = 2 * pi * u, b = 2 * pi * v;
            const double r = radius + tube * std::cos(b);
            return centre + Vec3d{r * std::cos(a), tube * std::sin(b), r * std::sin(a)};
          },
          2 * pi * radius, 2 * pi * tube};
}

// A rod with rounded ends.
Patch rod(Vec3d from, Vec3d to, double radius) {
  const Vec3d axis = normalized(to - from);
  const Vec3d side = normalized(cross(axis, std::abs(axis.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0}));
  const Vec3d other = cross(axis, side);
  const double size = length(to - from);
  return {[=](double u, double v) {
            const double s = u * (size + 2 * radius) - radius;
            const double over = s < 0 ? -s : std::max(0.0, s - size);
            const double r = std::sqrt(std::max(0.0, radius * radius - over * over));
            return from + axis * s + (side * std::cos(2 * pi * v) + other * std::sin(2 * pi * v)) * r;
          },
          size + 2 * radius, 2 * pi * radius};
}

void wheel(std::vector<Patch>& all, Vec3d hub) {
  all.push_back(ring(hub, 260, 55));
  all.push_back(ring(hub, 140, 4));
  all.push_back(blob(hub, {60, 70, 60}));
  for (int i = 0; i < 10; ++i) {
    const double a = 2 * pi * i / 10;
    all.push_back(rod(hub, hub + Vec3d{std::cos(a), 0, std::sin(a)} * 220, 9));
  }
}

void one_side(std::vector<Patch>& all, double y) {
  all.push_back(rod({330, y * 95, 320}, {560, y * 95, 900}, 24));      // fork
  all.push_back(rod({600, y * 60, 980}, {560, y * 250, 1030}, 11));    // handlebar
  all.push_back(rod({560, y * 250, 1030}, {650, y * 400, 1010}, 16));  // grip
  all.push_back(rod({540, y * 240, 1020}, {590, y * 395, 995}, 5));    // lever
  all.push_back(rod({560, y * 230, 1035}, {520, y * 330, 1180}, 5));   // mirror stalk
  all.push_back(blob({515, y * 350, 1200}, {12, 70, 45}, 0.7));        // mirror
  all.push_back(blob({430, y * 190, 820}, {35, 25, 22}));              // indicator
  all.push_back(blob({1950, y * 160, 780}, {35, 25, 22}));
  all.push_back(rod({1000, y * 120, 330}, {1010, y * 290, 340}, 12));  // peg
  all.push_back(rod({1350, y * 110, 400}, {1360, y * 270, 410}, 11));
  all.push_back(rod({1150, y * 130, 330}, {1700, y * 120, 320}, 22));  // swing arm
  all.push_back(rod({800, y * 110, 300}, {1250, y * 190, 260}, 28));   // exhaust
  all.push_back(rod({1250, y * 190, 260}, {1950, y * 210, 420}, 45));
  for (int i = 0; i < 9; ++i)  // cooling fins
    all.push_back(blob({900, y * 120, 420 + 24.0 * i}, {140, 80, 5}, 0.3));
  for (int i = 0; i < 40; ++i)  // bolts
    all.push_back(blob({850 + 11.0 * (i % 20), y * (235 + i % 3), 320 + 60.0 * (i / 20)}, {5, 5, 5}));
}

std::vector<Patch> patches() {
  std::vector<Patch> all;
  wheel(all, {320, 0, 315});
  wheel(all, {1690, 0, 315});
  for (const double y : {1.0, -1.0}) one_side(all, y);
  all.push_back(blob({850, 0, 850}, {280, 150, 140}, 0.8));  // tank
  all.push_back(blob({1400, 0, 830}, {380, 140, 60}, 0.6));  // seat
  all.push_back(blob({900, 0, 480}, {230, 190, 200}, 0.6));  // engine
  all.push_back(blob({470, 0, 880}, {130, 160, 150}, 0.8));  // lamp
  all.push_back(blob({1930, 0, 640}, {6, 110, 100}, 0.3));   // number plate
  all.push_back(blob({320, 0, 500}, {330, 65, 150}, 0.9));   // mudguard
  return all;
}

struct Counts {
  std::size_t along, around;
};

Counts counts(const Patch& patch, double step) {
  return {std::max<std::size_t>(6, static_cast<std::size_t>(patch.along / step)),
          std::max<std::size_t>(8, static_cast<std::size_t>(patch.around / step))};
}

double step_for(const std::vector<Patch>& all, std::size_t facets) {
  double low = 0.05, high = 200;
  for (int i = 0; i < 60; ++i) {
    const double step = (low + high) / 2;
    std::size_t count = 0;
    for (const Patch& patch : all) count += 2 * counts(patch, step).along * counts(patch, step).around;
    (count > facets ? low : high) = step;
  }
  return high;
}

Vec3d as_float(const Vec3d& p) {
  return {static_cast<double>(static_cast<float>(p.x)), static_cast<double>(static_cast<float>(p.y)),
          static_cast<double>(static_cast<float>(p.z))};
}

void add(const Patch& patch, Counts n, VertexWeld& weld, TriangleMesh& mesh) {
  std::vector<Vec3d> points;
  for (std::size_t i = 0; i <= n.along; ++i) {
    for (std::size_t j = 0; j < n.around; ++j)
      points.push_back(as_float(patch.at(static_cast<double>(i) / static_cast<double>(n.along),
                                         static_cast<double>(j) / static_cast<double>(n.around))));
  }
  std::vector<VertexId> number(points.size());
  weld.add(points, number.data());
  for (std::size_t i = 0; i < n.along; ++i) {
    for (std::size_t j = 0; j < n.around; ++j) {
      const std::size_t next = (j + 1) % n.around;
      const VertexId a = number[i * n.around + j], b = number[i * n.around + next];
      const VertexId c = number[(i + 1) * n.around + j], d = number[(i + 1) * n.around + next];
      mesh.facets.push_back({a, b, d});
      mesh.facets.push_back({a, d, c});
    }
  }
}

}  // namespace

Model stand_in(std::size_t facets) {
  const std::vector<Patch> all = patches();
  const double step = step_for(all, facets);
  Model model;
  model.bodies = {"stand-in"};
  VertexWeld weld(model.mesh.vertices, facets);
  for (const Patch& patch : all) add(patch, counts(patch, step), weld, model.mesh);
  model.box = bounding_box(model.mesh);
  return model;
}

}  // namespace gabarit
