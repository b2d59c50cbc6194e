#include "checks/exact_ray.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "checks/exact_ray_probe.h"
#include "model/brep_ray.h"
#include "tests/checks/wall_fields.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using step_shapes::loaded;
constexpr double infinity = std::numeric_limits<double>::infinity();

class ExactRays : public step_shapes::StepFiles {
 protected:
  Model model_of(const TopoDS_Shape& shape, double sag = 0.1) const {
    LoadOptions options;
    options.sag = sag;
    return loaded(step(shape), options);
  }
};

std::vector<ExactWall> rays_from_the_middles(const Model& model, RayOptions options = {}) {
  const Scene scene(model, Device::cpu());
  const ContactSurface& surface = scene.surface({.side = options.side, .sag = *model.sag});
  std::vector<FacetPlace> places;
  for (FacetId f = 0; f < model.mesh.facet_count(); ++f) places.push_back({f});
  return ExactRayWalls(scene, surface, options).measure(places);
}

TopoDS_Shape eccentric_tube() {
  return step_shapes::minus(step_shapes::cylinder(10, 30),
                            step_shapes::moved(step_shapes::cylinder(6, 30), 2, 0, 0));
}

// From p along the unit vector d to a circle about (x, 0), both in the plane z = 0: the nearer end ahead.
double to_circle(const Vec3d& p, const Vec3d& d, double x, double radius) {
  const double b = (p.x - x) * d.x + p.y * d.y;
  const double c = (p.x - x) * (p.x - x) + p.y * p.y - radius * radius, root = b * b - c;
  if (root < 0) return infinity;
  const double near = -b - std::sqrt(root), far = -b + std::sqrt(root);
  return near > 1e-6 ? near : far > 1e-6 ? far : infinity;
}

TEST_F(ExactRays, walls_of_an_eccentric_tube_are_as_long_as_their_formula_says) {
  const Model model = model_of(eccentric_tube(), 0.3);
  std::size_t asked = 0;
  for (const ExactWall& wall : rays_from_the_middles(model)) {
    ASSERT_TRUE(wall.measured);
    const double r = std::hypot(wall.at.x, wall.at.y), from_bore = std::hypot(wall.at.x - 2, wall.at.y);
    if (wall.at.z < 1e-6 || wall.at.z > 30 - 1e-6) {
      EXPECT_NEAR(wall.value, 30, 1e-9);
      continue;
    }
    const bool outer = std::abs(r - 10) < 1e-6;
    const Vec3d d = outer ? Vec3d{-wall.at.x / 10, -wall.at.y / 10, 0}
                          : Vec3d{(wall.at.x - 2) / from_bore, wall.at.y / from_bore, 0};
    EXPECT_NEAR(wall.value, std::min(to_circle(wall.at, d, 2, 6), to_circle(wall.at, d, 0, 10)), 1e-9);
    EXPECT_TRUE(wall.ball.verified);
    EXPECT_EQ(wall.off, 0);
    ++asked;
  }
  EXPECT_GT(asked, 40U);
}

TEST_F(ExactRays, a_torus_a_ball_and_a_cone_are_crossed_where_they_should_be) {
  for (const ExactWall& wall : rays_from_the_middles(model_of(step_shapes::sphere(7))))
    EXPECT_NEAR(wall.value, 14, 1e-9);
  for (const ExactWall& wall : rays_from_the_middles(model_of(step_shapes::torus(20, 5))))
    EXPECT_NEAR(wall.value, 10, 1e-8);
  for (const ExactWall& wall : rays_from_the_middles(model_of(step_shapes::cone(10, 20)))) {
    const double r = std::hypot(wall.at.x, wall.at.y);
    if (wall.at.z < 1e-6) {  // from the base straight up to the flank
      EXPECT_NEAR(wall.value, 20 - 2 * r, 1e-8);
      continue;
    }
    // Across the flank: to the opposite one, or to the base when that comes first.
    const double s = std::sin(std::atan2(1, 2)), c = std::cos(std::atan2(1, 2));
    EXPECT_NEAR(wall.value, std::min(wall.at.z / s, 2 * r / (c - s / 2)), 1e-8);
  }
}

// Newton's method from a grid over every face, without facets, tree or neighbours.
double brute_force(const Brep& brep, const Vec3d& from, const Vec3d& along) {
  constexpr int grid = 12;
  const BrepView arrays = view(brep);
  const RayFrame frame(from, along);
  double least = infinity;
  for (FaceId f = 0; f < brep.faces.size(); ++f) {
    const ParameterBox& r = brep.faces[f].range;
    for (int i = 0; i < grid * grid; ++i) {
      const int column = i % grid, line = i / grid;
      const Parameters start{r.u0 + (r.u1 - r.u0) * (column + 0.5) / grid,
                             r.v0 + (r.v1 - r.v0) * (line + 0.5) / grid};
      const RayMeeting m = meet_surface(arrays, brep.faces[f], frame, start, 1e-8);
      if (m.met && m.distance > 1e-4 && trim_side(arrays, f, m.at) == TrimSide::inside)
        least = std::min(least, m.distance);
    }
  }
  return least;
}

TEST_F(ExactRays, no_face_is_met_before_the_end_of_a_ray) {
  for (const TopoDS_Shape& shape :
       {step_shapes::rounded_box(40, 30, 20, 4), eccentric_tube(),
        step_shapes::minus(
            step_shapes::rounded_box(40, 30, 20, 4),
            step_shapes::turned(step_shapes::moved(step_shapes::cylinder(5, 60), 20, 12, -20), 20)),
        step_shapes::turned(step_shapes::torus(20, 5), 33)}) {
    const Model model = model_of(shape);
    const BrepView arrays = view(*model.brep);
    const std::vector<ExactWall> walls = rays_from_the_middles(model);
    for (FacetId f = 0; f < walls.size(); f += 1 + static_cast<FacetId>(walls.size() / 30)) {
      if (!walls[f].measured) continue;
      const Vec3d inward = -surface_place(arrays, model.brep->facets[f], {1 / 3., 1 / 3.}).normal;
      EXPECT_NEAR(walls[f].value, brute_force(*model.brep, walls[f].at, inward), 1e-6) << "facet " << f;
    }
  }
}

TEST_F(ExactRays, a_cone_of_rays_has_a_shortest_and_a_mean) {
  const Model model = model_of(step_shapes::box(200, 200, 2));
  RayOptions options{.cone = 30 * std::numbers::pi / 180, .rays = 9};
  double mean = 0;
  for (int i = 0; i < 9; ++i) mean += 2 / (1 - (1 - std::cos(options.cone)) * i / 8) / 9;
  for (const bool of_all : {false, true}) {
    options.mean = of_all;
    for (const ExactWall& wall : rays_from_the_middles(model, options)) {
      if (wall.at.z > 1e-6 && wall.at.z < 2 - 1e-6) continue;  // the narrow sides
      EXPECT_NEAR(wall.value, of_all ? mean : 2, 1e-9);
    }
  }
}

// The second wall of the ray lies right behind an edge, or right beside it.
TEST_F(ExactRays, a_ray_that_only_tolerance_lets_pass_an_edge_says_how_much_is_open) {
  Model model = model_of(step_shapes::together(
      {step_shapes::box(30, 30, 5), step_shapes::moved(step_shapes::box(10, 10, 2), 10 + 1e-6, 10, 10)}));
  ASSERT_EQ(model.mesh.facet_count(), 24U);
  FacetId top = 0;
  while (!(facet_normal(model.mesh, top).z > 0.9 && model.mesh.centroid(top).z < 6)) ++top;
  const auto [a, b, c] = model.mesh.corners(top);
  // Where (10, 15) lies on the facet, or (15, 10) where that half of the plate is the other one.
  const auto weights = [&, a = a, b = b, c = c](const Vec3d& p) {
    const Vec3d n = cross(b - a, c - a);
    return std::array{dot(cross(p - a, c - a), n) / dot(n, n), dot(cross(b - a, p - a), n) / dot(n, n)};
  };
  const auto width = [&](double tolerance) {
    for (Edge& edge : model.brep->edges) edge.tolerance = tolerance;
    for (BrepVertex& vertex : model.brep->vertices) vertex.tolerance = tolerance;
    const Scene scene(model, Device::cpu());
    const ContactSurface& surface = scene.surface({.side = Side::outside, .sag = 0.1});
    const ExactRayWalls rays(scene, surface, {.side = Side::outside});
    return rays.measure(std::vector<FacetPlace>{{top, weights({10, 15, 5})}}).front();
  };
  EXPECT_EQ(width(1e-7).value, infinity);
  EXPECT_NEAR(width(1e-5).value, 5, 1e-9);
}

Field by_rays(const Model& model, double limit, int threads = 1, const Measure& of = thickness_measure) {
  Wanted wanted = at_least(limit, *model.sag);
  wanted.parameters["method"] = "ray";
  wanted.device = Device::cpu(threads);
  return measure(of, model, wanted);
}

TEST_F(ExactRays, a_wall_of_just_the_limit_passes_and_a_thousandth_less_fails) {
  const Field just = by_rays(model_of(step_shapes::tube(10, 8.8, 30)), 1.2);
  EXPECT_GE(least_lower(just), 1.2);
  const Field less = by_rays(model_of(step_shapes::tube(10, 8.801, 30)), 1.2);
  EXPECT_LT(least_upper(less), 1.2);
  EXPECT_NEAR(least_value(less), 1.199, 1e-9);
}

TEST_F(ExactRays, the_shortest_ray_is_found_between_the_places_looked_at) {
  EXPECT_NEAR(least_value(by_rays(model_of(eccentric_tube(), 0.3), 2.5)), 2, 1e-6);
}

TEST_F(ExactRays, rays_that_shrink_towards_a_sharp_edge_are_not_followed_into_it) {
  // The flanks lean by 10 degrees: at the lower edges the material ends in 80 degrees, a ray from the bottom
  // is tan 80 degrees as long as its distance from the edge.
  const double lean = std::tan(10 * std::numbers::pi / 180);
  const Model model =
      model_of(step_shapes::prism({{0, 0}, {20, 0}, {20 - 10 * lean, 10}, {10 * lean, 10}}, 30));
  const Field field = by_rays(model, 1);
  const auto i = static_cast<std::size_t>(std::min_element(field.value.begin(), field.value.end()) -
                                          field.value.begin());
  EXPECT_GT(field.value[i], 0.05);
  EXPECT_NEAR(length(field.at[i] - field.contact[i]), field.value[i], 1e-6);
  EXPECT_LT(least_lower(field), 0.01) << "but the bounds know";
}

TEST_F(ExactRays, a_device_with_memory_apart_measures_the_same) {
  const Model model = model_of(step_shapes::tube(10, 8, 30), 0.2);
  Wanted wanted = at_least(3, *model.sag);
  for (const char* const method : {"ray", "wall"}) {
    wanted.parameters["method"] = method;
    wanted.device = Device::cpu(1);
    const Field here = measure(thickness_measure, model, wanted);
    wanted.device = Device::simulated(1);
    EXPECT_EQ(measure(thickness_measure, model, wanted).value, here.value);
  }
}

TEST_F(ExactRays, they_move_with_the_part_and_do_not_depend_on_the_threads) {
  const Model model = model_of(eccentric_tube(), 0.3);
  const Field here = by_rays(model, 2.5), two = by_rays(model, 2.5, 2);
  EXPECT_EQ(here.value, two.value);
  EXPECT_EQ(here.lower, two.lower);
  EXPECT_EQ(here.upper, two.upper);
  const Field there = by_rays(
      model_of(step_shapes::moved(step_shapes::turned(eccentric_tube(), 33), 900, -700, 80), 0.3), 2.5);
  EXPECT_NEAR(least_value(here), least_value(there), 2e-6);
}

TEST_F(ExactRays, facets_of_the_same_part_agree_wherever_their_bounds_decide) {
  for (const TopoDS_Shape& shape :
       {step_shapes::tube(10, 8.5, 30), step_shapes::rounded_box(40, 30, 6, 2),
        step_shapes::minus(step_shapes::box(40, 40, 5),
                           step_shapes::moved(step_shapes::cylinder(8, 20), 20, 11, -5))}) {
    const Model exact = model_of(shape, 0.2);
    Model facets = exact;
    facets.brep.reset();
    for (const double limit : {1.6, 5.5}) {
      const Field a = by_rays(exact, limit), b = by_rays(facets, limit);
      ASSERT_EQ(a.facets, b.facets);
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_FALSE(b.lower[i] >= limit && a.upper[i] < limit * (1 - 1e-9))
            << limit << " facet " << a.facets[i];
        EXPECT_FALSE(b.upper[i] < limit && a.lower[i] >= limit) << limit << " facet " << a.facets[i];
      }
    }
  }
}

TEST_F(ExactRays, the_gap_between_two_bodies_is_measured_the_same_way) {
  const TopoDS_Shape two = step_shapes::together(
      {step_shapes::cylinder(10, 30),
       step_shapes::minus(step_shapes::cylinder(20, 30), step_shapes::cylinder(13, 30))});
  const Field field = by_rays(model_of(two), 2.5, 1, clearance_measure);
  EXPECT_NEAR(least_value(field), 3, 1e-9);
  EXPECT_GE(least_lower(field), 2.5);
}

}  // namespace
}  // namespace gabarit
