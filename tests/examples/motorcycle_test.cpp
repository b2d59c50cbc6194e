#include "examples/motorcycle/motorcycle.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "gpu/triangle.h"
#include "model/defects.h"
#include "tests/examples/true_radius.h"

namespace gabarit::motorcycle {
namespace {

struct Built {
  Parts parts = motorcycle::parts();
  std::vector<Grid> grids;
  TriangleMesh mesh;

  explicit Built(const Tessellation& tessellation)
      : grids(motorcycle::grids(parts, tessellation)), mesh(motorcycle::mesh(parts, grids)) {}
};

const Built& coarse() {
  static const Built built({.sag = 0.4, .step = 6});
  return built;
}

TEST(Motorcycle, it_has_between_400_and_500_thousand_facets_as_delivered) {
  Parts all = parts();
  grids(all, {});
  EXPECT_GT(all.back().last, 400000U);
  EXPECT_LT(all.back().last, 500000U);
}

TEST(Motorcycle, it_stands_on_the_ground_and_is_as_large_as_a_motorcycle) {
  const Box3d box = bounding_box(coarse().mesh);
  EXPECT_EQ(box.min.z, 0.0);
  EXPECT_NEAR(box.extent().x, 2050, 10);
  EXPECT_NEAR(box.extent().y, 1000, 5);
  EXPECT_NEAR(box.extent().z, 1150, 5);
  EXPECT_NEAR(box.min.x, -front_wheel_radius, 0.5) << "it faces -x";
}

TEST(Motorcycle, all_parts_together_are_closed_and_oriented) {
  const Defects defects = find_defects(coarse().mesh);
  EXPECT_TRUE(defects.watertight());
  EXPECT_EQ(defects.degenerate, 0U);
  EXPECT_EQ(defects.duplicate, 0U);
}

// Of the facets of one surface, by the divergence theorem.
double volume(const Surface& surface, const Grid& grid) {
  double six_volumes = 0;
  tessellate(surface, grid,
             [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) { six_volumes += dot(a, cross(b, c)); });
  return six_volumes / 6;
}

TEST(Motorcycle, every_solid_is_outward) {
  auto grid = coarse().grids.begin();
  for (const Part& part : coarse().parts) {
    for (const Surface& surface : part.surfaces) EXPECT_GT(volume(surface, *grid++), 0) << part.name;
  }
}

// The largest distance from places of the surface inside a facet's parameters to the nearest of its cell's
// facets.
double deviation(const Surface& surface, const Grid& grid) {
  std::vector<std::array<Vec3d, 3>> facets;
  tessellate(surface, grid, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    facets.push_back({a, b, c});
  });
  double worst = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const auto [p] = parameters(surface, grid, i);
    for (const auto& [a, b] : {std::pair{1.0 / 3, 1.0 / 3}, {0.5, 0.5}, {0.5, 0.0}, {0.0, 0.5}}) {
      const Vec2 q = (1 - a - b) * p[0] + a * p[1] + b * p[2];
      const Vec3d on = surface.at(q.x, q.y);
      double distance = 1e9;
      for (std::size_t k = i - std::min<std::size_t>(i, 2); k < std::min(i + 3, facets.size()); ++k) {
        const auto& [r, s, t] = facets[k];
        distance = std::min(distance, length(on - closest_point(on, r, s, t)));
      }
      worst = std::max(worst, distance);
    }
  }
  return worst;
}

TEST(Motorcycle, no_facet_departs_from_its_true_surface_by_more_than_the_sag) {
  auto grid = coarse().grids.begin();
  for (const Part& part : coarse().parts) {
    for (const Surface& surface : part.surfaces) EXPECT_LE(deviation(surface, *grid++), 0.4) << part.name;
  }
}

}  // namespace
}  // namespace gabarit::motorcycle
