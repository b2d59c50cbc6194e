#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "checks/exact_probe.h"
#include "gpu/tangent_ball.h"
#include "model/brep_foot.h"
#include "tests/dense_boundary.h"
#include "tests/shapes.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using step_shapes::loaded;
constexpr double degree = std::numbers::pi / 180;
constexpr double wall = 120 * degree, any = 20 * degree;

class ExactBallTest : public step_shapes::StepFiles {};

// A model with its walls and random places on it.
struct Part {
  Model model;
  Scene scene;
  const ContactSurface& surface;
  ExactWallOptions options;
  ExactWalls walls;
  std::vector<FacetPlace> places;
  std::vector<ExactWall> found;

  Part(Model m, double separation, Side side = Side::inside, std::size_t count = 400)
      : model(std::move(m)),
        scene(model, Device::cpu(1)),
        surface(scene.surface({.side = side, .crease = 0.7, .sag = *model.sag})),
        options{.side = side, .separation = separation},
        walls(scene, surface, options) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> weight(0, 1);
    for (std::size_t i = 0; i < count; ++i) {
      double v = weight(random), w = weight(random);
      if (v + w > 1) v = 1 - v, w = 1 - w;
      const auto facet = static_cast<FacetId>(random() % model.mesh.facet_count());
      places.push_back({facet, {v, w}});
    }
    found = walls.measure(places);
  }
  const Surface& surface_at(std::size_t i) const {
    return model.brep->surfaces[model.brep->faces[model.brep->facets[places[i].facet].face].surface];
  }
};

// No point of the boundary that counts lies inside a ball that was found, by more than 1e-4 of the ball.
void expect_none_beats(const Part& part, std::size_t a_face) {
  const Brep& brep = *part.model.brep;
  const BrepView arrays = view(brep);
  const double sign = part.options.side == Side::inside ? 1 : -1;
  const std::vector<BoundaryPoint> boundary = dense_boundary(brep, a_face);
  std::size_t beaten = 0, unverified = 0;
  for (std::size_t i = 0; i < part.found.size(); ++i) {
    const ExactWall& w = part.found[i];
    if (!w.measured) continue;
    unverified += w.ball.verified ? 0 : 1;
    const FacetOrigin& origin = brep.facets[part.places[i].facet];
    const auto [v, u] = part.places[i].weights;
    const Face& face = brep.faces[origin.face];
    const SurfacePoint s = face_point(arrays, face, parameters_at(origin, 1 - v - u, v, u));
    const Vec3d d = outward_normal(s, face.sign) * -sign;
    for (const auto& [p, n] : boundary) {
      if (sign * dot(n, d) < -std::cos(part.options.separation) || length(p - s.p) < 1e-6 * part.surface.size)
        continue;
      if (2 * ball_through_point(d, p - s.p).radius < w.value * (1 - 1e-4)) {
        if (beaten++ == 0)
          ADD_FAILURE() << "place " << i << " reads " << w.value << " (" << name(w.ball.kind) << "), not "
                        << 2 * ball_through_point(d, p - s.p).radius;
        break;
      }
    }
  }
  EXPECT_EQ(beaten, 0U);
  EXPECT_EQ(unverified, 0U);
}

TEST_F(ExactBallTest, a_shell_is_as_thick_as_its_radii_differ) {
  const Part part(loaded(step(step_shapes::minus(step_shapes::sphere(10), step_shapes::sphere(8)))), wall);
  for (const ExactWall& w : part.found) EXPECT_TRUE(!w.measured || std::abs(w.value - 2) < 1e-9) << w.value;
  expect_none_beats(part, 4000);
}

TEST_F(ExactBallTest, a_box_is_as_thick_as_it_is_long_across_each_face) {
  const Part part(loaded(step(step_shapes::box(10, 20, 30))), wall);
  for (std::size_t i = 0; i < part.found.size(); ++i) {
    const Vec3d n = facet_normal(part.model.mesh, part.places[i].facet);
    EXPECT_NEAR(part.found[i].value, std::fabs(n.x) * 10 + std::fabs(n.y) * 20 + std::fabs(n.z) * 30, 1e-9);
  }
}

TEST_F(ExactBallTest, a_solid_torus_is_as_thick_as_its_tube) {
  const Part part(loaded(step(step_shapes::torus(20, 5))), wall);
  for (const ExactWall& w : part.found) EXPECT_NEAR(w.value, 10, 1e-7);
}

TEST_F(ExactBallTest, a_tube_with_an_offset_bore_follows_the_formula) {
  const Part part(loaded(step(step_shapes::minus(step_shapes::cylinder(10, 60),
                                                 step_shapes::moved(step_shapes::cylinder(6, 60), 2, 0, 0)))),
                  wall);
  std::size_t checked = 0;
  for (std::size_t i = 0; i < part.found.size(); ++i) {
    const Vec3d p = part.found[i].at;
    if (part.surface_at(i).kind != SurfaceKind::cylinder || std::abs(std::hypot(p.x, p.y) - 10) > 1e-6)
      continue;
    const double c = p.x / 10;
    EXPECT_NEAR(part.found[i].value, 2 * (68 - 40 * c) / (32 - 4 * c), 1e-7);
    ++checked;
  }
  EXPECT_GT(checked, 50U);
  expect_none_beats(part, 4000);
}

TEST_F(ExactBallTest, a_wedge_of_thirty_degrees_thins_to_nothing) {
  const double height = 40 * std::tan(30 * degree);
  const Part part(loaded(step(step_shapes::prism({{0, 0}, {40, 0}, {40, height}}, 500))), wall);
  std::size_t checked = 0;
  for (std::size_t i = 0; i < part.found.size(); ++i) {
    const Vec3d p = part.found[i].at;
    if (facet_normal(part.model.mesh, part.places[i].facet).y > -0.99 || p.x > 30) continue;
    EXPECT_NEAR(part.found[i].value, 2 * p.x * std::tan(15 * degree), 1e-7);
    ++checked;
  }
  EXPECT_GT(checked, 20U);
}

TEST_F(ExactBallTest, nothing_beats_what_is_found_on_rounded_and_bored_parts) {
  expect_none_beats(Part(loaded(step(step_shapes::rounded_box(40, 30, 20, 3))), any), 1500);
  expect_none_beats(Part(loaded(step(step_shapes::rounded_box(40, 30, 20, 3))), wall), 1500);
  const TopoDS_Shape plate = step_shapes::minus(
      step_shapes::box(60, 60, 8), step_shapes::moved(step_shapes::cylinder(12, 30), 30, 30, -5));
  expect_none_beats(Part(loaded(step(plate)), any), 4000);
  expect_none_beats(Part(loaded(step(plate)), any, Side::outside), 4000);
}

// The ball that touches a cone all around has its centre on the axis.
TEST_F(ExactBallTest, a_cone_thins_out_towards_its_apex) {
  const Part part(loaded(step(step_shapes::turned(step_shapes::cone(10, 25), 33))), wall);
  const double tangent = 10.0 / 25;
  const Vec3d apex{0, -25 * std::sin(33 * degree), 25 * std::cos(33 * degree)};
  std::size_t checked = 0;
  for (std::size_t i = 0; i < part.found.size(); ++i) {
    if (part.surface_at(i).kind != SurfaceKind::cone || !part.found[i].measured) continue;
    EXPECT_NEAR(part.found[i].value, 2 * length(part.found[i].at - apex) * tangent, 1e-7);
    ++checked;
  }
  EXPECT_GT(checked, 100U);
  expect_none_beats(part, 4000);
}

// Straight below it nothing counts but the tip, where the parameters of the cone have a pole.
TEST_F(ExactBallTest, the_tip_of_a_drilled_hole_stops_the_ball) {
  const TopoDS_Shape drill = step_shapes::turned(step_shapes::cone(3, 5), 180);
  const Part part(
      loaded(step(step_shapes::minus(step_shapes::box(12, 12, 20), step_shapes::moved(drill, 6, 6, 20)))),
      wall, Side::inside, 4000);
  std::size_t checked = 0;
  for (std::size_t i = 0; i < part.found.size(); ++i) {
    const Vec3d p = part.found[i].at;
    const double aside = std::hypot(p.x - 6, p.y - 6);
    if (p.z > 1e-9 || aside > 4) continue;
    EXPECT_NEAR(part.found[i].value, (aside * aside + 225) / 15, 1e-6) << aside;
    ++checked;
  }
  EXPECT_GT(checked, 3U);
  expect_none_beats(part, 500);
}

// The edge of the lower step is longer than the part of it that lies ahead of the slanted side.
TEST_F(ExactBallTest, an_edge_that_lies_partly_behind_the_surface_is_followed) {
  const TopoDS_Shape steps = step_shapes::prism({{0, 0}, {60, 0}, {60, 6}, {30, 6}, {30, 20}, {0, 20}}, 80);
  const TopoDS_Shape knife =
      step_shapes::moved(step_shapes::turned(step_shapes::box(100, 100, 100), 50), -10, 60, -20);
  const Part part(loaded(step(step_shapes::minus(steps, knife))), wall, Side::inside, 800);
  expect_none_beats(part, 4000);
}

// Ten millimetres between the surfaces, at the middle of the facets across the thin way of a box.
CellAnswer beside_facets_that_say(const Part& part, double value, double lower, double upper) {
  CellAnswer facets;
  facets.value = value, facets.lower = lower, facets.upper = upper;
  const Probe probe = exact_probe([&](std::span<const CellQuery>, std::span<CellAnswer> a) { a[0] = facets; },
                                  part.walls, Extreme::smallest);
  for (FacetId f = 0; f < part.model.mesh.facet_count(); ++f) {
    if (std::fabs(facet_normal(part.model.mesh, f).x) < 0.5) continue;
    CellQuery query;
    query.facet = f, query.weights = {1.0 / 3, 1.0 / 3};
    CellAnswer answer;
    probe({&query, 1}, {&answer, 1});
    return answer;
  }
  return {};
}

TEST_F(ExactBallTest, a_place_that_the_surfaces_call_thinner_cannot_pass_on_the_word_of_its_facet) {
  const Part part(loaded(step(step_shapes::box(10, 40, 60))), wall, Side::inside, 1);
  const CellAnswer agreed = beside_facets_that_say(part, 10.1, 9, 11);
  EXPECT_EQ(agreed.value, 10);
  EXPECT_EQ(agreed.lower, 9);
  const CellAnswer thinner = beside_facets_that_say(part, 13, 12, 14);
  EXPECT_EQ(thinner.value, 13);
  EXPECT_NEAR(thinner.lower, 10, 1e-9);
  const CellAnswer thicker = beside_facets_that_say(part, 8, 7, 9);
  EXPECT_EQ(thicker.value, 8);
  EXPECT_EQ(thicker.lower, 7);
}

}  // namespace
}  // namespace gabarit
