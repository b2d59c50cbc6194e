// Balls, rays and closest points: the tree finds what a look at every primitive finds.
#include <gtest/gtest.h>

#include "gpu/closest_point.h"
#include "gpu/maximal_sphere.h"
#include "gpu/maximal_sphere_kernel.h"
#include "gpu/ray_cast.h"
#include "gpu/sphere_lower_bound.h"
#include "gpu/traverse.h"
#include "gpu/triangle.h"
#include "tests/block_solid.h"
#include "tests/gpu/tree_surfaces.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

std::vector<SphereQuery> random_queries(std::size_t count, unsigned seed, bool loose) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-6, 6), part(0, 1);
  std::vector<SphereQuery> queries;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d at{place(random), place(random), place(random)};
    const Vec3d towards{place(random), place(random), place(random)};
    queries.push_back({at, normalized(towards), static_cast<std::uint32_t>(i), 0, 0, 0});
    if (!loose) continue;
    queries.back().sag = static_cast<float>(0.05 * part(random));
    queries.back().spacing = static_cast<float>(0.3 * part(random));
    queries.back().tilt = static_cast<float>(0.1 * part(random));
  }
  return queries;
}

std::vector<SphereContact> ask(const Bvh& tree, const SphereOptions& options,
                               const std::vector<SphereQuery>& queries) {
  std::vector<SphereContact> found(queries.size());
  maximal_spheres(tree, options, queries, found);
  return found;
}

class Balls : public testing::TestWithParam<double> {};

TEST_P(Balls, are_those_of_a_look_at_every_facet_edge_and_vertex) {
  const SphereOptions options{.cos_separation = GetParam(), .greatest_radius = 30, .contact_floor = 1e-6};
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Bvh tree(Device::cpu(1), random_surface(700, seed == 3 ? 6 : 0.8, seed));
    const BvhView view = tree.view();
    SphereOptions bounded = options;
    bounded.greatest_radius = std::min(30.0, 4.0 * static_cast<double>(view.reach));
    const std::vector<SphereQuery> queries = random_queries(300, seed, false);
    const std::vector<SphereContact> found = ask(tree, options, queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      MaximalSphere all(view, bounded, queries[i]);
      for (std::int64_t k = 0; k < view.primitives.size; ++k) all.visit(view.primitives[k]);
      EXPECT_EQ(found[i].radius, all.result().radius);
      EXPECT_EQ(found[i].primitive, all.result().primitive);
    }
  }
}

// The lower bound of a ball whose point, direction and surface may be a little elsewhere.
TEST_P(Balls, of_places_nearby_are_no_smaller_than_their_lower_bound) {
  const SphereOptions options{.cos_separation = GetParam(), .greatest_radius = 30, .contact_floor = 1e-6};
  const Bvh tree(Device::cpu(1), random_surface(700, 0.8, 4));
  const std::vector<SphereQuery> loose = random_queries(300, 4, true);
  const std::vector<SphereContact> bounds = ask(tree, options, loose);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi), part(0, 1);
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<SphereQuery> moved = loose;
    for (SphereQuery& q : moved) {
      const Vec3d d = q.direction;
      const Vec3d across = normalized(cross(d, std::fabs(d.x) < 0.7 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
      const double a = turn(random);
      q.point += part(random) * static_cast<double>(q.spacing) *
                 (std::cos(a) * across + std::sin(a) * cross(d, across));
      q.sag = q.spacing = q.tilt = 0;
    }
    const std::vector<SphereContact> found = ask(tree, options, moved);
    for (std::size_t i = 0; i < moved.size(); ++i)
      EXPECT_GE(found[i].radius, bounds[i].lower * (1 - 1e-12)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Tree, Balls, testing::Values(1.0, 0.94, -0.5));

TEST(Rays, hit_what_a_look_at_every_facet_hits) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const FacetSurface surface = random_surface(600, seed == 3 ? 6 : 0.8, seed);
    const Bvh tree(Device::cpu(1), surface);
    std::vector<Ray> rays;
    for (const SphereQuery& q : random_queries(1000, seed, false))
      rays.push_back({q.point, q.direction, no_child, 1e-6});
    rays[0].direction = {0, 0, 1}, rays[1].direction = {0, -1, 0};
    std::vector<RayHit> hits(rays.size());
    cast_rays(tree, rays, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Primitive& p : surface.primitives) {
        if (!p.is_facet()) continue;
        const Vec3d a = surface.points[p.corner[0]], b = surface.points[p.corner[1]],
                    c = surface.points[p.corner[2]];
        const Vec3d n = cross(b - a, c - a), d = rays[i].direction;
        const double t = dot(a - rays[i].point, n) / dot(d, n);
        const Vec3d at = rays[i].point + t * d;
        if (t > 0 && t < nearest && length(at - closest_point(at, a, b, c)) < 1e-9) nearest = t;
      }
      if (std::isfinite(nearest))
        EXPECT_NEAR(hits[i].distance, nearest, 1e-8) << i;
      else
        EXPECT_EQ(hits[i].facet, no_child) << i;
    }
  }
}

TEST(ClosestPoints, are_those_of_a_look_at_every_facet) {
  const FacetSurface surface = random_surface(600, 2, 9);
  const Bvh tree(Device::cpu(1), surface);
  std::vector<Vec3d> points;
  for (const SphereQuery& q : random_queries(500, 9, false)) points.push_back(q.point);
  std::vector<ClosestPoint> closest(points.size());
  closest_points(tree, points, closest);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Primitive& p : surface.primitives) {
      if (!p.is_facet()) continue;
      const auto corner = [&](std::size_t k) { return surface.points[p.corner[k]]; };
      nearest =
          std::min(nearest, length(points[i] - closest_point(points[i], corner(0), corner(1), corner(2))));
    }
    EXPECT_NEAR(closest[i].distance, nearest, 1e-12);
  }
}

// Nodes, leaves and primitives that a search looks at.
class Counted : public MaximalSphere {
 public:
  using MaximalSphere::MaximalSphere;
  std::size_t looks = 0;

  template <class Boxes>
  void within(const Boxes& boxes, EightFloats& lower) {
    ++looks;
    MaximalSphere::within(boxes, lower);
  }
  void visit(const Primitive& p) {
    ++looks;
    MaximalSphere::visit(p);
  }
};

// Mean over about a thousand facets, each from nothing.
double looks_of_a_search(const TriangleMesh& mesh) {
  const Bvh tree(Device::cpu(1), surface_of(mesh));
  const BvhView view = tree.view();
  const SphereOptions options{.cos_separation = 1,
                              .greatest_radius = 4.0 * static_cast<double>(view.reach),
                              .contact_floor = 1e-6 * length(bounding_box(mesh).extent())};
  double looks = 0, searches = 0;
  for (std::size_t f = 0; f < mesh.facet_count(); f += mesh.facet_count() / 1000 + 1) {
    const auto id = static_cast<FacetId>(f);
    const SphereQuery query{mesh.centroid(id), -facet_normal(mesh, id), id, 0, 0, 0};
    Counted search(view, options, query);
    traverse(view, search);
    looks += static_cast<double>(search.looks), ++searches;
  }
  return looks / searches;
}

// Sixteen times the facets: a search that grew with their number would look at sixteen times as much. Inside
// a ball every facet is equally far away, inside a torus every facet of a ring.
TEST(Balls, in_finely_meshed_balls_and_tori_do_not_take_a_look_at_everything) {
  const auto ball = [](int n) { return shapes::mesh(shapes::sphere(50, n, 2 * n)); };
  const auto torus = [](int n) { return shapes::mesh(shapes::torus(50, 12, 2 * n, n)); };
  EXPECT_LT(looks_of_a_search(ball(240)), 5 * looks_of_a_search(ball(60)));
  EXPECT_LT(looks_of_a_search(torus(240)), 5 * looks_of_a_search(torus(60)));
  EXPECT_LT(looks_of_a_search(ball(240)),
            20 * looks_of_a_search(shapes::with_facets(shapes::ribbed_casting(), 1e5)));
}

}  // namespace
}  // namespace gabarit
