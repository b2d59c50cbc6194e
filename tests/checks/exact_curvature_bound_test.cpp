#include <random>

#include "checks/curvature_bound.h"
#include "checks/radius_exact.h"
#include "checks/rolled_ball.h"
#include "model/brep_curvature.h"
#include "tests/shapes.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using step_shapes::loaded;
constexpr double infinity = std::numeric_limits<double>::infinity();

class CurvatureBounds : public step_shapes::StepFiles {
 protected:
  Model spline_model(const TopoDS_Shape& shape) const { return loaded(step(step_shapes::as_splines(shape))); }
};

double bound_of(const Brep& brep, const ParameterBox& box, double sign = 1) {
  const std::array<Parameters, 4> all{
      {{box.u0, box.v0}, {box.u1, box.v0}, {box.u1, box.v1}, {box.u0, box.v1}}};
  return curvature_bound(view(brep), brep.surfaces[0], sign, box, all).greatest;
}

double at(const Brep& brep, double u, double v, double sign = 1) {
  return principal_curvatures(surface_point(view(brep), brep.surfaces[0], u, v), sign).greatest;
}

// The greatest of a grid of the box.
double by_force(const Brep& brep, const ParameterBox& box, double sign = 1) {
  constexpr int n = 40;
  double most = -infinity;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j)
      most = std::max(most,
                      at(brep, box.u0 + (box.u1 - box.u0) * i / n, box.v0 + (box.v1 - box.v0) * j / n, sign));
  }
  return most;
}

// One Bézier patch over the unit square, of degrees p and q, about 10 mm large; `weight` is how much weights
// differ.
Brep patch(int p, int q, double rough, double weight, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> in(-1, 1);
  Brep brep;
  Surface s;
  s.kind = SurfaceKind::spline;
  s.u_degree = p, s.v_degree = q, s.u_poles = p + 1, s.v_poles = q + 1;
  s.domain = {0, 1, 0, 1};
  for (int k = 0; k < 2 * (p + 1); ++k) brep.knots.push_back(k > p ? 1 : 0);
  s.first_v_knot = static_cast<std::uint32_t>(brep.knots.size());
  for (int k = 0; k < 2 * (q + 1); ++k) brep.knots.push_back(k > q ? 1 : 0);
  for (int i = 0; i <= p; ++i) {
    for (int j = 0; j <= q; ++j) {
      const double w = 1 + weight * in(random);
      brep.poles.push_back({w * (10. * i / p + rough * in(random)), w * (10. * j / q + rough * in(random)),
                            w * 2 * rough * in(random), w});
    }
  }
  brep.surfaces = {s};
  return brep;
}

TEST(CurvatureBound, no_place_of_a_random_patch_is_sharper_than_its_bound_which_closes_in) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> in(0, 1);
  for (unsigned seed = 0; seed < 24; ++seed) {
    const int p = 1 + static_cast<int>(seed % 5), q = 2 + static_cast<int>(seed % 3);
    const Brep brep = patch(p, q, 0.8, seed % 2 == 0 ? 0.3 : 0, seed);
    for (double size = 0.2; size > 0.01; size /= 2) {
      const double u = in(random) * (1 - size), v = in(random) * (1 - size);
      const ParameterBox box{u, u + size, v, v + size};
      for (const double sign : {1.0, -1.0}) {
        const double most = by_force(brep, box, sign), bound = bound_of(brep, box, sign);
        EXPECT_GE(bound, most) << "patch " << seed << " size " << size;
        if (size < 0.03) {
          EXPECT_LE(bound, most + 0.02 * std::fabs(most) + 0.005) << "patch " << seed;
        }
      }
    }
  }
}

TEST(CurvatureBound, it_does_not_depend_on_placement_scale_nor_on_the_order_of_parameters) {
  const ParameterBox box{0.3, 0.36, 0.5, 0.58}, swapped{0.5, 0.58, 0.3, 0.36};
  const Brep brep = patch(3, 4, 0.6, 0.2, 5);
  const double bound = bound_of(brep, box);
  Brep moved = brep;  // turned about z and far away
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (Pole& p : moved.poles)
    p = {c * p.x - s * p.y + 2000 * p.w, s * p.x + c * p.y - 1000 * p.w, p.z + 500 * p.w, p.w};
  EXPECT_NEAR(bound_of(moved, box), bound, 1e-4 * bound);  // 2 m away
  EXPECT_GE(bound_of(moved, box), by_force(moved, box));
  Brep larger = brep;
  for (Pole& p : larger.poles) p = {8 * p.x, 8 * p.y, 8 * p.z, p.w};
  EXPECT_NEAR(bound_of(larger, box), bound / 8, 1e-9 * bound);
  Brep across;  // u for v
  Surface t = brep.surfaces[0];
  std::swap(t.u_degree, t.v_degree), std::swap(t.u_poles, t.v_poles),
      std::swap(t.first_u_knot, t.first_v_knot);
  for (int j = 0; j < t.u_poles; ++j) {
    for (int i = 0; i < t.v_poles; ++i)
      across.poles.push_back(brep.poles[static_cast<std::size_t>(i * t.u_poles + j)]);
  }
  across.knots = brep.knots, across.surfaces = {t};
  EXPECT_NEAR(bound_of(across, swapped, -1), bound, 0.02 * bound);
  EXPECT_GE(bound_of(across, swapped, -1), by_force(across, swapped, -1));
}

Field radius_of_faces(const Model& model) {
  Region region = whole_model(model.mesh);
  region.edges.assign(model.mesh.facet_count(), {Selected::no, Selected::no, Selected::no});
  return measure_exact_radius(Scene(model, Device::cpu()), region);
}

// x²/49 + y²/49 + z²/12.25 = 1: at the equator 1/7 around and 7/12.25 up and down.
TEST_F(CurvatureBounds, an_ellipsoid_is_sharpest_at_its_equator) {
  Model model = spline_model(step_shapes::sphere(7));
  for (Pole& p : model.brep->poles) p.z *= 0.5;
  const Field field = radius_of_faces(model);
  const double truth = 12.25 / 7;
  EXPECT_NEAR(*std::min_element(field.value.begin(), field.value.end()), truth, 2e-6);
  const double lower = *std::min_element(field.lower.begin(), field.lower.end());
  EXPECT_LE(lower, truth);
  EXPECT_GT(lower, 0.998 * truth);
}

// One facet over evenly spaced spans of a line of which four bend a little.
Model ridged_sheet(int spans) {
  Model model;
  Brep brep;
  Curve c;
  c.kind = CurveKind::spline;
  c.degree = 3, c.pole_count = spans + 3, c.last = spans;
  for (int k = -3; k <= spans + 3; ++k) brep.knots.push_back(std::clamp(k, 0, spans));
  // Evenly spaced poles but at the ends, where the knots are: the parameter runs evenly.
  for (int i = 0; i < c.pole_count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double x = (brep.knots[k + 1] + brep.knots[k + 2] + brep.knots[k + 3]) / 3;
    brep.poles.push_back({x, i == 143 ? 1.0 : 0.0, 0, 1});
  }
  brep.curves = {c};
  Surface s;
  s.kind = SurfaceKind::extrusion;
  s.curve = 0, s.domain = {0, c.last, -infinity, infinity};
  brep.surfaces = {s};
  Face face;
  face.surface = 0, face.sign = -1, face.range = {0, c.last, 0, 100};
  brep.faces = {face};
  brep.trims = {{.box = {}, .all = true}};
  FacetOrigin origin;
  origin.face = 0, origin.corners = {Parameters{0, 0}, Parameters{c.last, 0}, Parameters{0, 100}};
  brep.facets = {origin};
  for (const Parameters& p : origin.corners) model.mesh.vertices.push_back(face_point(view(brep), face, p).p);
  model.mesh.facets = {{0, 1, 2}}, model.mesh.body = {0}, model.bodies = {"sheet"};
  model.brep = brep;
  return model;
}

// Narrower than any grid of 16 places a side.
TEST(CurvatureBound, a_ridge_between_all_samples_of_a_facet_is_not_passed) {
  constexpr int spans = 300;
  const Model model = ridged_sheet(spans);
  double of_samples = 0, truth = 0;
  for (int i = 0; i <= 16; ++i) of_samples = std::max(of_samples, at(*model.brep, spans * i / 16., 0, -1));
  for (int i = 0; i <= 60000; ++i) truth = std::max(truth, at(*model.brep, spans * i / 60000., 0, -1));
  EXPECT_LT(of_samples, 1e-9);
  EXPECT_GT(truth, 0.5);
  const Field field = radius_of_faces(model);
  EXPECT_LE(field.lower[0], 1 / truth);
  EXPECT_NEAR(field.value[0], 1 / truth, 2e-3 / truth);
}

TEST(CurvatureBound, a_facet_over_more_spans_than_can_be_looked_at_has_no_bound) {
  EXPECT_EQ(radius_of_faces(ridged_sheet(30'000)).lower[0], 0);
}

double greatest_of_balls(const Model& model) {
  const std::vector<double> of = rolled_balls(*model.brep, Device::cpu());
  return *std::max_element(of.begin(), of.end());
}

TEST_F(CurvatureBounds, spheres_cylinders_and_rings_are_known_behind_splines_and_nothing_else_is) {
  const Model ball = spline_model(step_shapes::sphere(7));
  EXPECT_NEAR(greatest_of_balls(ball), 1 / 7., 1e-11);
  EXPECT_NEAR(greatest_of_balls(spline_model(step_shapes::cylinder(3, 10))), 1 / 3., 1e-11);
  const TopoDS_Shape ring = step_shapes::moved(step_shapes::torus(20, 5), 100, -50, 7);
  EXPECT_NEAR(greatest_of_balls(spline_model(step_shapes::turned(ring, 33))), 1 / 5., 1e-11);
  EXPECT_EQ(greatest_of_balls(spline_model(step_shapes::elliptic_cylinder(10, 9.999, 30))), 0);
  Model dented = ball, hollow = ball;
  for (Pole& p : dented.brep->poles) p.z *= 1 + 1e-9;
  EXPECT_EQ(greatest_of_balls(dented), 0);
  for (Face& f : hollow.brep->faces) f.sign = -f.sign;
  EXPECT_EQ(greatest_of_balls(hollow), 0);
}

}  // namespace
}  // namespace gabarit
