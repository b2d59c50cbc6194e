#include "checks/radius_exact.h"

#include <limits>
#include <numbers>
#include <set>

#include <gmock/gmock.h>

#include "checks/facet_turns.h"
#include "model/brep_curvature.h"
#include "tests/shapes.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using step_shapes::loaded;
using testing::ElementsAre;
constexpr double infinity = std::numeric_limits<double>::infinity();

class RadiusExact : public step_shapes::StepFiles {
 protected:
  Model model_of(const TopoDS_Shape& shape) const { return loaded(step(shape)); }
};

Field measured(const Model& model) {
  return measure_exact_radius(Scene(model, Device::cpu()), whole_model(model.mesh));
}

// All that differ, ascending.
std::set<double> radii(const Field& field) { return {field.value.begin(), field.value.end()}; }

void expect_bounds_equal_values(const Field& field) {
  EXPECT_EQ(field.lower, field.value);
  EXPECT_EQ(field.upper, field.value);
}

TEST_F(RadiusExact, a_rounded_box_reads_its_radius_to_the_last_digit_and_planes_are_without_limit) {
  for (const double r : {3.0, 3.999, 4.0, 5.0}) {
    const Field field = measured(model_of(step_shapes::rounded_box(60, 40, 30, r)));
    EXPECT_THAT(radii(field), ElementsAre(r, infinity));
    expect_bounds_equal_values(field);
  }
}

TEST_F(RadiusExact, r4_passes_a_limit_of_4_and_r3_999_fails_it) {
  const auto worst = [](const Field& field) {
    return *std::min_element(field.lower.begin(), field.lower.end());
  };
  EXPECT_GE(worst(measured(model_of(step_shapes::rounded_box(60, 40, 30, 4)))), 4);
  EXPECT_LT(worst(measured(model_of(step_shapes::rounded_box(60, 40, 30, 3.999)))), 4);
  EXPECT_LT(worst(measured(model_of(step_shapes::rounded_box(60, 40, 30, 4 - 2e-6)))), 4);
}

TEST_F(RadiusExact, a_radius_in_inches_is_as_exact) {
  const Field field = measured(loaded(step(step_shapes::rounded_box(60, 40, 30, 25.4 / 8), "INCH")));
  EXPECT_THAT(radii(field), ElementsAre(3.175, infinity));
}

TEST_F(RadiusExact, it_does_not_depend_on_the_tessellation_nor_on_the_placement) {
  const TopoDS_Shape shape = step_shapes::rounded_box(60, 40, 30, 4);
  LoadOptions coarse;
  coarse.sag = 1.0;
  EXPECT_THAT(radii(measured(loaded(step(shape), coarse))), ElementsAre(4, infinity));
  EXPECT_THAT(radii(measured(model_of(step_shapes::moved(step_shapes::turned(shape, 33), 1e3, -2e3, 500)))),
              ElementsAre(4, infinity));
}

TEST_F(RadiusExact, every_facet_of_a_box_has_a_sharp_edge) {
  const Model model = model_of(step_shapes::box(10, 20, 30));
  const Field field = measured(model);
  EXPECT_THAT(radii(field), ElementsAre(0));
  expect_bounds_equal_values(field);
  for (const Vec3d& contact : field.contact) {  // in the middle of an edge: two coordinates on the outside
    const int outside = (contact.x < 1e-9 || contact.x > 10 - 1e-9) +
                        (contact.y < 1e-9 || contact.y > 20 - 1e-9) +
                        (contact.z < 1e-9 || contact.z > 30 - 1e-9);
    EXPECT_GE(outside, 2);
  }
}

TEST_F(RadiusExact, spheres_and_tori_read_their_smaller_radius) {
  EXPECT_THAT(radii(measured(model_of(step_shapes::sphere(7)))), ElementsAre(7));
  EXPECT_THAT(radii(measured(model_of(step_shapes::torus(20, 5)))), ElementsAre(5));
}

TEST_F(RadiusExact, a_bore_is_hollow_its_rim_is_sharp_and_its_outside_is_round) {
  const Model model = model_of(step_shapes::tube(10, 8, 30));
  EXPECT_THAT(radii(measured(model)), ElementsAre(0));  // every facet reaches a rim
  Region region = whole_model(model.mesh);
  region.edges.assign(model.mesh.facet_count(), {Selected::no, Selected::no, Selected::no});
  const Field field = measure_exact_radius(Scene(model, Device::cpu()), region);
  EXPECT_THAT(radii(field), ElementsAre(10, infinity));
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vec3d c = model.mesh.centroid(field.facets[i]);
    const bool in_bore = std::hypot(c.x, c.y) < 8;
    EXPECT_TRUE(!in_bore || field.value[i] == infinity);
  }
}

TEST_F(RadiusExact, an_apex_is_sharp_and_a_cone_is_sharper_nearer_to_it) {
  const Model model = model_of(step_shapes::cone(10, 20));
  const Field field = measured(model);
  const double slope = std::atan2(10, 20);
  for (std::size_t i = 0; i < field.size(); ++i) {
    const auto corners = model.mesh.corners(field.facets[i]);
    const double top = std::max({corners[0].z, corners[1].z, corners[2].z});
    const double bottom = std::min({corners[0].z, corners[1].z, corners[2].z});
    if (bottom < 1e-9) continue;  // at the sharp rim
    EXPECT_NEAR(field.value[i], (20 - top) / 2 / std::cos(slope), 1e-6);
  }
}

TEST_F(RadiusExact, edges_that_are_not_touched_do_not_count) {
  const Model model = model_of(step_shapes::box(10, 20, 30));
  Region region = whole_model(model.mesh);
  region.edges.assign(model.mesh.facet_count(), {Selected::no, Selected::no, Selected::no});
  EXPECT_THAT(radii(measure_exact_radius(Scene(model, Device::cpu()), region)), ElementsAre(infinity));
  region.edges[3] = {Selected::yes, Selected::yes, Selected::yes};
  const Field field = measure_exact_radius(Scene(model, Device::cpu()), region);
  EXPECT_EQ(field.value[3], 0);
  EXPECT_GE(std::count(field.value.begin(), field.value.end(), 0.0), 3);  // and across those edges
  EXPECT_GE(std::count(field.value.begin(), field.value.end(), infinity), 6);
}

TEST_F(RadiusExact, an_edge_that_may_be_touched_lowers_the_lower_bound_only) {
  const Model model = model_of(step_shapes::box(10, 20, 30));
  Region region = whole_model(model.mesh);
  region.edges.assign(model.mesh.facet_count(), {Selected::maybe, Selected::maybe, Selected::maybe});
  const Field field = measure_exact_radius(Scene(model, Device::cpu()), region);
  for (std::size_t i = 0; i < field.size(); ++i) {
    EXPECT_EQ(field.lower[i], 0);
    EXPECT_EQ(field.upper[i], infinity);
  }
}

TEST_F(RadiusExact, the_free_edge_of_an_open_surface_is_unknown) {
  const Model model = model_of(step_shapes::without_a_face(step_shapes::box(10, 20, 30)));
  Region region = whole_model(model.mesh);
  const Field open = measure_exact_radius(Scene(model, Device::cpu()), region);
  for (const double lower : open.lower) EXPECT_EQ(lower, 0);
}

Field of_faces_alone(const Model& model) {
  Region region = whole_model(model.mesh);
  region.edges.assign(model.mesh.facet_count(), {Selected::no, Selected::no, Selected::no});
  return measure_exact_radius(Scene(model, Device::cpu()), region);
}

// The greatest curvature on a dense grid of the facet, a hair inside it: what lies beyond a knot is the next
// one's.
double sharpest_by_force(const Model& model, FacetId f) {
  constexpr int n = 60;
  const BrepView brep = view(*model.brep);
  const FacetOrigin& origin = model.brep->facets[f];
  const Face& face = model.brep->faces[origin.face];
  double most = 0;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      constexpr double inside = 1 - 1e-9, third = 1e-9 / 3;
      const double v = inside * i / n + third, w = inside * j / n + third;
      const SurfacePoint s = face_point(brep, face, parameters_at(origin, 1 - v - w, v, w));
      most = std::max(most, principal_curvatures(s, face.sign).greatest);
    }
  }
  return most;
}

TEST_F(RadiusExact, an_elliptic_cylinder_is_as_sharp_as_b2_by_a) {
  LoadOptions coarse;
  coarse.sag = 0.3;
  for (const TopoDS_Shape& shape : {step_shapes::elliptic_cylinder(10, 6, 30),
                                    step_shapes::turned(step_shapes::elliptic_cylinder(10, 6, 30), 33),
                                    step_shapes::as_splines(step_shapes::elliptic_cylinder(10, 6, 30))}) {
    const Field field = of_faces_alone(loaded(step(shape), coarse));
    EXPECT_NEAR(*std::min_element(field.value.begin(), field.value.end()), 3.6, 2e-6);
    const double lower = *std::min_element(field.lower.begin(), field.lower.end());
    EXPECT_LE(lower, 3.6);
    EXPECT_GT(lower, 3.4);
  }
}

TEST_F(RadiusExact, the_bounds_of_splines_hold_what_a_dense_grid_finds) {
  LoadOptions coarse;
  coarse.sag = 0.5;
  std::vector<double> one_sharp(24, 10.0);
  one_sharp[5] = 10.4;
  for (const TopoDS_Shape& shape :
       {step_shapes::lobed_cylinder(one_sharp, 20), step_shapes::lobed_cylinder({10, 7, 10, 7, 10, 7}, 20),
        step_shapes::elliptic_cylinder(10, 6, 30)}) {
    const Model model = loaded(step(shape), coarse);
    const Field field = of_faces_alone(model);
    for (std::size_t i = 0; i < field.size(); ++i) {
      const double most = sharpest_by_force(model, field.facets[i]);
      if (field.value[i] == infinity) {
        EXPECT_LT(most, 1e-9);
        continue;
      }
      EXPECT_LE(most * field.lower[i], 1 + 1e-7) << "facet " << field.facets[i];
      EXPECT_LE(most * field.value[i], 1.002) << "facet " << field.facets[i];
      EXPECT_LE(field.lower[i], field.value[i]);
    }
  }
}

TEST_F(RadiusExact, splines_that_are_balls_rings_and_fillets_read_their_radius_without_doubt) {
  const auto least = [&](const TopoDS_Shape& shape) {
    const Field field = of_faces_alone(loaded(step(step_shapes::as_splines(shape))));
    return std::pair{*std::min_element(field.lower.begin(), field.lower.end()),
                     *std::min_element(field.upper.begin(), field.upper.end())};
  };
  EXPECT_EQ(least(step_shapes::sphere(7)), std::pair(7.0, 7.0));
  EXPECT_EQ(least(step_shapes::torus(20, 5)), std::pair(5.0, 5.0));
  EXPECT_EQ(least(step_shapes::rounded_box(60, 40, 30, 4)), std::pair(4.0, 4.0));
}

TEST_F(RadiusExact, a_surface_without_points_has_no_radius_rather_than_none_that_is_too_small) {
  Model model = model_of(step_shapes::as_splines(step_shapes::torus(20, 5)));
  for (Pole& pole : model.brep->poles) pole.w = 0;
  const Field field = of_faces_alone(model);
  for (std::size_t i = 0; i < field.size(); ++i) {
    EXPECT_TRUE(std::isnan(field.value[i]));
    EXPECT_NE(field.absence[i], Absence::none);
    EXPECT_EQ(field.lower[i], 0);
  }
}

// One face, an extrusion along z of a line with a corner: an angle iron seen from outside or inside.
Brep kinked(double sign) {
  Brep brep;
  Curve c;
  c.kind = CurveKind::spline;
  c.degree = 1, c.pole_count = 3, c.first = 0, c.last = 2;
  brep.poles = {{10, 0, 0, 1}, {0, 0, 0, 1}, {0, 10, 0, 1}};
  brep.knots = {0, 0, 1, 2, 2};
  brep.curves = {c};
  Surface s;
  s.kind = SurfaceKind::extrusion;
  s.curve = 0;
  s.domain = {0, 2, -infinity, infinity};
  brep.surfaces = {s};
  Face f;
  f.surface = 0, f.sign = sign;
  brep.faces = {f};
  FacetOrigin across, beside;
  across.face = beside.face = 0;
  across.corners = {Parameters{0.5, 0}, Parameters{1.5, 0}, Parameters{0.5, 5}};
  beside.corners = {Parameters{0.1, 0}, Parameters{0.5, 0}, Parameters{0.1, 5}};
  brep.facets = {across, beside};
  return brep;
}

// From (10, 0) by (0, 0) to (0, 10) with z up: du × dv looks towards (1, 1) on the inner side of the corner.
TEST(KinkTurns, a_kink_inside_a_face_is_found_on_its_convex_side) {
  const std::vector<float> one = kink_turns(kinked(1), Device::cpu()),
                           other = kink_turns(kinked(-1), Device::cpu());
  EXPECT_NEAR(std::max(one[0], other[0]), std::numbers::pi / 2, 1e-6);
  EXPECT_EQ(std::min(one[0], other[0]), 0);
  EXPECT_EQ(one[1], 0);
  EXPECT_EQ(other[1], 0);
  // dS/du = (-10, 0, 0) before the corner, dS/dv = z: the normal (0, 10, 0) of sign 1 looks inwards.
  EXPECT_EQ(one[0], 0);
}

}  // namespace
}  // namespace gabarit
