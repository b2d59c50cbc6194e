#include "examples/motorcycle/motorcycle.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "examples/motorcycle/groups.h"
#include "gpu/triangle.h"
#include "model/defects.h"
#include "tests/examples/built.h"
#include "tests/examples/true_radius.h"

namespace gabarit::motorcycle {
namespace {

std::size_t facets(double step) {
  Parts all = parts();
  grids(all, {.step = step});
  return all.back().last;
}

TEST(Motorcycle, the_documented_steps_give_the_documented_numbers_of_facets) {
  EXPECT_GT(facets(usual_step), 400000U);
  EXPECT_LT(facets(usual_step), 500000U);
  EXPECT_NEAR(static_cast<double>(facets(fine_step)), 2.7e6, 0.05e6);
  EXPECT_NEAR(static_cast<double>(facets(finest_step)), 12e6, 0.2e6);
}

TEST(Motorcycle, it_stands_on_the_ground_and_is_as_large_as_a_motorcycle) {
  const Box3d box = coarse().model.box;
  EXPECT_EQ(box.min.z, 0.0);
  EXPECT_NEAR(box.extent().x, 2050, 10);
  EXPECT_NEAR(box.extent().y, 1000, 5);
  EXPECT_NEAR(box.extent().z, 1150, 5);
  EXPECT_NEAR(box.min.x, -front_wheel_radius, 0.5) << "it faces -x";
}

TEST(Motorcycle, all_facets_together_are_closed_and_oriented) {
  const Defects defects = count_defects(coarse().model.mesh);
  EXPECT_TRUE(watertight(defects));
  EXPECT_EQ(defects.degenerate, 0U);
  EXPECT_EQ(defects.duplicate, 0U);
}

TEST(Motorcycle, parts_have_names_of_their_own_and_follow_each_other) {
  std::set<std::string> names;
  FacetId next = 0;
  for (const Part& part : coarse().parts) {
    EXPECT_TRUE(names.insert(part.name).second) << part.name;
    EXPECT_EQ(part.first, next);
    EXPECT_LT(part.first, part.last);
    next = part.last;
  }
  EXPECT_EQ(next, coarse().model.mesh.facet_count());
}

// By the divergence theorem.
double volume(const Surface& surface, const Grid& grid) {
  double six_volumes = 0;
  tessellate(surface, grid,
             [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) { six_volumes += dot(a, cross(b, c)); });
  return six_volumes / 6;
}

TEST(Motorcycle, every_solid_has_its_facets_outward) {
  auto grid = coarse().grids.begin();
  for (const Part& part : coarse().parts) {
    for (const Surface& surface : part.surfaces) EXPECT_GT(volume(surface, *grid++), 0) << part.name;
  }
}

TEST(Motorcycle, two_runs_give_the_same_coordinates) {
  const auto checksum = [] {
    Parts all = parts();
    const std::vector<Grid> lines = grids(all, {.sag = 0.4, .step = 6});
    std::vector<SingleFacet> facets;
    tessellate(all, lines, [&](const SingleFacet& facet) { facets.push_back(facet); });
    return facets;
  };
  EXPECT_TRUE(checksum() == checksum());
}

TEST(Motorcycle, coordinates_of_the_mesh_are_those_of_the_file) {
  for (const Vec3d& v : coarse().model.mesh.vertices) {
    volatile float x = static_cast<float>(v.x), y = static_cast<float>(v.y), z = static_cast<float>(v.z);
    ASSERT_EQ(v, (Vec3d{x, y, z}));
  }
}

// The largest distance from places of the surface to the facets around: sampled inside each facet's
// parameters.
double deviation(const Surface& surface, const Grid& grid) {
  std::vector<std::array<Vec3d, 3>> all;
  tessellate(surface, grid, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    all.push_back({a, b, c});
  });
  double worst = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto [p] = parameters(surface, grid, i);
    for (const auto& [a, b] : {std::pair{1.0 / 3, 1.0 / 3}, {0.5, 0.5}, {0.5, 0.0}, {0.0, 0.5}}) {
      const Vec2 q = (1 - a - b) * p[0] + a * p[1] + b * p[2];
      const Vec3d on = surface.at(q.x, q.y);
      double distance = 1e9;
      for (std::size_t k = i - std::min<std::size_t>(i, 2); k < std::min(i + 3, all.size()); ++k) {
        const auto& [r, s, t] = all[k];
        distance = std::min(distance, length(on - closest_point(on, r, s, t)));
      }
      worst = std::max(worst, distance);
    }
  }
  return worst;
}

TEST(Motorcycle, no_facet_departs_from_its_true_surface_by_more_than_the_sag) {
  for (const Tessellation& tessellation : {Tessellation{.sag = 0.4, .step = 6}, Tessellation{}}) {
    Parts all = parts();
    const std::vector<Grid> lines = grids(all, tessellation);
    auto grid = lines.begin();
    double used = 0;
    for (const Part& part : all) {
      for (const Surface& surface : part.surfaces) {
        const double share = deviation(surface, *grid++) / tessellation.sag;
        EXPECT_LE(share, 1) << part.name;
        used = std::max(used, share);
      }
    }
    EXPECT_GT(used, 0.8) << "the sag is made use of";
  }
}

TEST(Motorcycle, no_edge_across_a_small_rounding_is_longer_than_the_step) {
  EXPECT_LE(longest_edge(3, {.sag = 1, .step = 1.5}), 1.5);
  EXPECT_DOUBLE_EQ(longest_edge(24, {.sag = 10, .step = 1.5}), 3);
  EXPECT_DOUBLE_EQ(longest_edge(1e9, {.sag = 10, .step = 1.5}), 60);
}

TEST(Motorcycle, sharp_and_round_are_as_the_list_says_where_the_column_does_not_get) {
  const Built& built = coarse();
  Region everywhere;
  everywhere.facets.assign(built.model.mesh.facet_count(), Selected::yes);
  everywhere.edges.assign(built.model.mesh.facet_count(), {Selected::yes, Selected::yes, Selected::yes});
  const auto found = touched_parts(built.parts, built.grids, everywhere);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Part& part = built.parts[i];
    if (part.expectation != Expectation::out_of_reach) continue;
    EXPECT_NEAR(found[i].radius, part.true_radius, 0.05 * part.true_radius) << part.name;
  }
}

}  // namespace
}  // namespace gabarit::motorcycle
