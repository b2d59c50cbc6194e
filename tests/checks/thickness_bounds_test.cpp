// The bounds of a facet against many places of it, each measured alone.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "gpu/tangent_ball.h"
#include "tests/block_solid.h"
#include "tests/checks/wall_fields.h"

namespace gabarit {
namespace {

using shapes::Triangles;

constexpr double cos_separation = -0.5;

Vec3d to_double(const Vec3f& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

// The definition, over all facets, edges and vertices; a contact on an edge or vertex counts when the surface
// leaves it away from the ball.
double diameter_by_definition(const BvhView& tree, FacetId own, const Vec3d& point, const Vec3d& d,
                              double floor) {
  double least = INFINITY;
  for (std::int64_t i = 0; i < tree.primitives.size; ++i) {
    const Primitive& p = tree.primitives[i];
    if (p.id == own) continue;
    const Vec3d a = tree.corner(p, 0) - point, b = tree.corner(p, 1) - point;
    TangentBall ball;
    if (p.is_facet()) {
      if (dot(to_double(p.normal), d) < -cos_separation) continue;
      ball = ball_through_triangle(d, a, b, tree.corner(p, 2) - point, INFINITY);
    } else {
      double at = 0;
      ball = p.corner[0] == p.corner[1] ? ball_through_point(d, a) : ball_through_segment(d, a, b, &at);
      if (p.corner[0] != p.corner[1] && (at <= 0 || at >= 1)) continue;
      const Vec3d outward = normalized(ball.contact - ball.radius * d);
      bool leaves = dot(outward, d) >= -cos_separation;
      for (std::uint32_t k = tree.fan_first[p.corner[2]]; k < tree.fan_first[p.corner[2] + 1]; ++k)
        leaves = leaves && dot(to_double(tree.fan_directions[k]), outward) > -1e-6;
      if (!leaves) continue;
    }
    if (length(ball.contact) > floor) least = std::min(least, 2 * ball.radius);
  }
  return least;
}

void expect_no_place_beats_the_bounds(const Triangles& shape, const Wanted& wanted, int every) {
  const Model model = shapes::model(shape, wanted.sag);
  const Field field = measure(thickness_measure, model, wanted);
  const Scene scene(model, Device::cpu(1));
  const SurfaceOptions options{.crease = 40 * M_PI / 180, .sag = wanted.sag};
  const ContactSurface& surface = scene.surface(options);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (std::size_t i = 0; i < field.size(); i += static_cast<std::size_t>(every)) {
    const FacetId f = field.facets[i];
    if (field.absence[i] != Absence::none) continue;
    for (int sample = 0; sample < 40; ++sample) {
      double v = share(random), w = share(random);
      if (v + w > 1) v = 1 - v, w = 1 - w;
      const auto blend = [&](const Vec3d& p, const Vec3d& q, const Vec3d& r) {
        return p + v * (q - p) + w * (r - p);
      };
      const auto c = model.mesh.corners(f);
      const auto& n = surface.normals[f];
      const Vec3d d = -normalized(blend(to_double(n[0]), to_double(n[1]), to_double(n[2])));
      const double there =
          diameter_by_definition(surface.tree.view(), f, blend(c[0], c[1], c[2]), d, 1e-6 * surface.size);
      ASSERT_LE(field.lower[i], there * (1 + 1e-9) + 1e-9) << "facet " << f;
    }
    EXPECT_LE(field.lower[i], field.value[i] * (1 + 1e-12));
    EXPECT_GE(field.upper[i], field.value[i] * (1 - 1e-12));
  }
}

TEST(ThicknessBounds, hold_at_every_place_of_flat_facets) {
  expect_no_place_beats_the_bounds(tapered_plate(), {}, 1);
  expect_no_place_beats_the_bounds(tapered_plate(), at_least(3), 1);
  expect_no_place_beats_the_bounds(grooved(1.5), at_least(2), 1);
  expect_no_place_beats_the_bounds(l_bracket(3, 7), {}, 2);
  expect_no_place_beats_the_bounds(prism({{0, 0}, {30, 0}, {26, 15}}, 10), at_least(4), 1);
}

TEST(ThicknessBounds, hold_at_every_place_of_curved_facets) {
  expect_no_place_beats_the_bounds(shapes::revolve({{8, 0}, {10, 0}, {10, 6}, {8, 6}, {8, 0}}, 36),
                                   at_least(1.9), 9);
  expect_no_place_beats_the_bounds(shapes::torus(12, 4, 24, 16), at_least(7), 23);
  expect_no_place_beats_the_bounds(
      shapes::joined(shapes::sphere(10, 12, 20), shapes::flipped(shapes::sphere(8, 9, 14))), {}, 19);
  // A waisted ring: reflex edges in both directions.
  expect_no_place_beats_the_bounds(
      shapes::revolve(
          {{5, 0}, {12, 0}, {9, 4}, {8, 6}, {9, 8}, {12, 12}, {5, 12}, {6.5, 7}, {6.5, 5}, {5, 0}}, 20),
      at_least(2), 3);
}

TEST(ThicknessBounds, hold_at_every_place_of_a_part_with_ribs_and_a_handle) {
  const auto triangles = [](const TriangleMesh& mesh) {
    Triangles out;
    for (FacetId f = 0; f < mesh.facet_count(); ++f) out.push_back(mesh.corners(f));
    return out;
  };
  expect_no_place_beats_the_bounds(triangles(shapes::with_facets(shapes::cup_with_a_handle(), 900)), {}, 71);
  expect_no_place_beats_the_bounds(triangles(shapes::with_facets(shapes::ribbed_casting(), 900)), at_least(3),
                                   71);
}

// How far they may be apart, in percent of the value, on bodies whose value is known: see docs/thickness.md.
TEST(ThicknessBounds, are_as_narrow_as_the_documentation_says) {
  const auto widest = [](const Triangles& shape, double& below, double& above) {
    const Field field = thickness(shape);
    below = above = 0;
    for (std::size_t i = 0; i < field.size(); ++i) {
      below = std::max(below, 1 - field.lower[i] / field.value[i]);
      above = std::max(above, field.upper[i] / field.value[i] - 1);
    }
  };
  double below = 0, above = 0;
  widest(shapes::gridded_box({0, 0, 0}, {40, 30, 2}, 7), below, above);
  EXPECT_LT(below, 1e-5);
  EXPECT_LT(above, 1e-9);
  widest(shapes::revolve({{8, 0}, {10, 0}, {10, 6}, {8, 6}, {8, 0}}, 36), below, above);
  EXPECT_LT(below, 0.08);
  EXPECT_LT(above, 0.04);
  widest(shapes::sphere(10, 40, 80), below, above);
  EXPECT_LT(below, 0.07);
  EXPECT_LT(above, 0.04);
  widest(shapes::torus(30, 4, 60, 30), below, above);
  EXPECT_LT(below, 0.12);
  EXPECT_LT(above, 0.06);
}

}  // namespace
}  // namespace gabarit
