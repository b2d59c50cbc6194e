// Every kind of work on every kind of surface: the same bits on every device at hand.
#include <algorithm>

#include <gtest/gtest.h>

#include "gpu/bumpy_ball.h"
#include "gpu/closest_point.h"
#include "gpu/maximal_sphere.h"
#include "gpu/query_trials.h"
#include "gpu/ray_cast.h"
#include "tests/block_solid.h"
#include "tests/gpu/other_devices.h"
#include "tests/gpu/tree_surfaces.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

FacetSurface surface_of(const shapes::Triangles& triangles) {
  return gabarit::surface_of(shapes::mesh(triangles));
}

// As many pieces stand on the same corners.
FacetSurface copied(FacetSurface surface, std::uint32_t times) {
  const std::vector<Primitive> once = surface.primitives;
  for (std::uint32_t i = 1; i < times; ++i) {
    for (Primitive p : once) {
      p.id += i * static_cast<std::uint32_t>(once.size());
      surface.primitives.push_back(p);
    }
  }
  return surface;
}

shapes::Triangles part_of(shapes::Triangles triangles, std::size_t from, std::size_t to) {
  return {triangles.begin() + static_cast<std::ptrdiff_t>(from),
          triangles.begin() + static_cast<std::ptrdiff_t>(to)};
}

// Needles that meet in a point.
shapes::Triangles needles() { return shapes::revolve({{0, 0}, {50, 0.5}, {50, 3}, {0, 3}}, 400); }

struct Kind {
  const char* name;
  FacetSurface (*make)();
};

const std::vector<Kind> kinds{
    {"bumpy_ball", [] { return bumpy_ball(20, 30, 10, 0.2); }},
    {"ball_of_near_ties", [] { return bumpy_ball(20, 30, 10, 0); }},
    {"small_ball_far_away",
     [] {
       return bumpy_ball(12, 16, 0.5, 0.1, {9000, -4000, 250});
     }},
    {"box_of_twelve",
     [] {
       return surface_of(shapes::box({0, 0, 0}, {20, 8, 2}));
     }},
    {"turned_box",
     [] {
       return surface_of(
           shapes::rotated(shapes::gridded_box({0, 0, 0}, {20, 8, 2}, 1), normalized(Vec3d{1, 2, 3}), 0.7));
     }},
    {"gridded_box",
     [] {
       return surface_of(shapes::gridded_box({0, 0, 0}, {20, 8, 2}, 1));
     }},
    {"torus", [] { return surface_of(shapes::torus(20, 5, 40, 20)); }},
    {"tube",
     [] {
       return surface_of(shapes::revolve({{8, 0}, {10, 0}, {10, 30}, {8, 30}, {8, 0}}, 64));
     }},
    {"casting", [] { return gabarit::surface_of(shapes::with_facets(shapes::ribbed_casting(), 2000)); }},
    {"open_sheet",
     [] {
       return surface_of(part_of(shapes::gridded_box({0, 0, 0}, {9, 9, 1}, 1), 0, 100));
     }},
    {"needles", [] { return surface_of(needles()); }},
    {"copies",
     [] {
       return copied(surface_of(shapes::box({0, 0, 0}, {3, 4, 5})), 9);
     }},
    {"one_facet",
     [] {
       return surface_of({{{{0, 0, 0}, {3, 0, 1}, {0, 2, 2}}}});
     }},
};

class OnEverySurface : public testing::TestWithParam<Kind> {};

TEST_P(OnEverySurface, every_kind_of_work_gives_the_same_bits_on_every_device) {
  const FacetSurface surface = GetParam().make();
  for (const QueryTrial& trial : query_trials()) {
    const auto bits_on = [&](const Device& device) {
      const PreparedTrial prepared = trial.prepare(device, surface);
      prepared.run();
      return prepared.bits();
    };
    const std::vector<std::uint64_t> expected = bits_on(plain_cpu);
    EXPECT_FALSE(expected.empty()) << trial.name;
    for (const auto& [name, device] : other_devices())
      EXPECT_TRUE(expected == bits_on(device)) << trial.name << " on " << name;
  }
}

INSTANTIATE_TEST_SUITE_P(SameBits, OnEverySurface, testing::ValuesIn(kinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST(SameBits, of_answers_that_differ_from_place_to_place) {
  const FacetSurface surface = bumpy_ball(20, 30, 10, 0.2);
  for (const QueryTrial& trial : query_trials()) {
    const PreparedTrial prepared = trial.prepare(plain_cpu, surface);
    prepared.run();
    const std::vector<std::uint64_t> bits = prepared.bits();
    EXPECT_NE(*std::min_element(bits.begin(), bits.end()), *std::max_element(bits.begin(), bits.end()))
        << trial.name;
  }
}

// Balls that feel edges and vertices, with and without bounds that are asked for, rays and closest points.
std::vector<double> answers(const Device& device, const FacetSurface& surface, double cos_separation) {
  const Bvh tree(device, surface);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(-6, 6), part(0, 1);
  std::vector<SphereQuery> queries;
  for (std::uint32_t i = 0; i < 400; ++i) {
    const Vec3d at{place(random), place(random), place(random)};
    const Vec3d towards = normalized(Vec3d{place(random), place(random), place(random)});
    const float loose = i % 2 == 0 ? 0 : static_cast<float>(0.05 * part(random));
    queries.push_back({at, towards, i, loose, 2 * loose, loose});
  }
  std::vector<Ray> rays;
  std::vector<Vec3d> points;
  for (const SphereQuery& q : queries)
    rays.push_back({q.point, q.direction, no_child, 1e-6}), points.push_back(q.point);
  std::vector<SphereContact> spheres(queries.size());
  std::vector<RayHit> hits(queries.size());
  std::vector<ClosestPoint> closest(queries.size());
  maximal_spheres(tree, {.cos_separation = cos_separation, .greatest_radius = 30, .contact_floor = 1e-6},
                  queries, spheres);
  cast_rays(tree, rays, hits);
  closest_points(tree, points, closest);
  std::vector<double> all;
  for (const SphereContact& c : spheres)
    all.insert(all.end(),
               {c.radius, c.lower, c.upper, c.contact.x, c.contact.y, c.contact.z, double(c.primitive)});
  for (const RayHit& hit : hits) all.insert(all.end(), {hit.distance, hit.facing, double(hit.facet)});
  for (const ClosestPoint& c : closest)
    all.insert(all.end(), {c.distance, c.point.x, c.point.y, c.point.z, double(c.facet)});
  return all;
}

TEST(SameBits, of_surfaces_with_edges_and_vertices_that_balls_can_touch) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const FacetSurface surface = random_surface(700, seed == 3 ? 6 : 0.8, seed);
    for (const double cos_separation : {1.0, 0.94, -0.5}) {
      const std::vector<double> expected = answers(plain_cpu, surface, cos_separation);
      for (const auto& [name, device] : other_devices())
        EXPECT_EQ(expected, answers(device, surface, cos_separation)) << name << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace gabarit
