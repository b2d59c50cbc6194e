#include "model/brep_trim.h"

#include <numbers>
#include <random>

#include <BRepTopAdaptor_FClass2d.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gtest/gtest.h>

#include "model/brep_surface.h"
#include "model/occt_topology.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

constexpr double pi = std::numbers::pi;

Brep brep_of(const TopoDS_Shape& shape) {
  Brep brep;
  add_topology(shape, 0, brep);
  return brep;
}

TopoDS_Shape plate_with_hole(double radius) {
  return step_shapes::minus(step_shapes::box(100, 80, 6),
                            step_shapes::moved(step_shapes::cylinder(radius, 20), 50, 40, -5));
}

// A little beyond the range of the face on every side.
Parameters random_place(const Face& face, std::mt19937& random) {
  std::uniform_real_distribution<double> share(-0.2, 1.2);
  const ParameterBox& r = face.range;
  return {r.u0 + share(random) * (r.u1 - r.u0), r.v0 + share(random) * (r.v1 - r.v0)};
}

// OpenCASCADE's own classifier, which says "on" within a tolerance of the curves.
void expect_as_classified(const TopoDS_Shape& shape) {
  const Brep brep = brep_of(shape);
  EXPECT_EQ(brep.untrimmed, 0U);
  EXPECT_EQ(brep.leaky, 0U);
  const BrepView arrays = view(brep);
  std::mt19937 random(3);
  FaceId f = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next(), ++f) {
    const Surface& surface = brep.surfaces[brep.faces[f].surface];
    BRepTopAdaptor_FClass2d classifier(TopoDS::Face(it.Current()), 1e-6);
    std::size_t inside = 0;
    for (int i = 0; i < 500; ++i) {
      const Parameters at = random_place(brep.faces[f], random);
      // OpenCASCADE extrapolates splines; here they end.
      if (!surface.u_periodic && (at.u < surface.domain.u0 || at.u > surface.domain.u1)) continue;
      if (!surface.v_periodic && (at.v < surface.domain.v0 || at.v > surface.domain.v1)) continue;
      const TopAbs_State state = classifier.Perform(gp_Pnt2d(at.u, at.v));
      if (state == TopAbs_ON) continue;
      const TrimSide side = trim_side(arrays, f, at);
      inside += side == TrimSide::inside ? 1 : 0;
      ASSERT_EQ(side == TrimSide::inside, state == TopAbs_IN)
          << "face " << f << " (" << name(surface.kind) << ") at " << at.u << ", " << at.v;
    }
    EXPECT_GT(inside, 50U) << "face " << f;
  }
  EXPECT_EQ(f, brep.faces.size());
}

TEST(BrepTrim, faces_of_planes_cylinders_cones_spheres_and_tori_are_cut_as_the_kernel_cuts_them) {
  expect_as_classified(step_shapes::box(10, 20, 30));
  expect_as_classified(step_shapes::cylinder(10, 30));
  expect_as_classified(step_shapes::tube(10, 8, 30));
  expect_as_classified(step_shapes::cone(10, 20));
  expect_as_classified(step_shapes::sphere(10));
  expect_as_classified(step_shapes::torus(20, 5));
}

TEST(BrepTrim, faces_with_holes_fillets_and_slanted_cuts_are_cut_as_the_kernel_cuts_them) {
  expect_as_classified(plate_with_hole(31.5));
  expect_as_classified(step_shapes::rounded_box(40, 30, 20, 4));
  // A cylinder through a cylinder: its curves are splines in both parameter planes.
  expect_as_classified(step_shapes::minus(
      step_shapes::cylinder(10, 40),
      step_shapes::moved(step_shapes::turned(step_shapes::cylinder(4, 60), 90), 2, 30, 20)));
  // A plane that leaves an ellipse.
  expect_as_classified(step_shapes::minus(
      step_shapes::cylinder(10, 40),
      step_shapes::moved(step_shapes::turned(step_shapes::box(60, 60, 60), 30), -30, -30, 30)));
  expect_as_classified(step_shapes::minus(step_shapes::sphere(10),
                                          step_shapes::moved(step_shapes::cylinder(3, 40), 4, 0, -20)));
  expect_as_classified(step_shapes::minus(step_shapes::torus(20, 5),
                                          step_shapes::moved(step_shapes::box(30, 60, 30), 8, -30, -15)));
}

// Thirty-two chords for the circle would be off by 0.15 mm.
TEST(BrepTrim, a_hole_ends_at_its_circle_to_a_millionth) {
  const double r = 31.5;
  const Brep brep = brep_of(plate_with_hole(r));
  const BrepView arrays = view(brep);
  std::size_t lids = 0;
  for (FaceId f = 0; f < brep.faces.size(); ++f) {
    if (brep.surfaces[brep.faces[f].surface].kind != SurfaceKind::plane) continue;
    const SurfacePoint s = face_point(arrays, brep.faces[f], {0, 0});
    if (std::fabs(cross(s.du, s.dv).z) < 0.5) continue;
    ++lids;
    for (int i = 0; i < 400; ++i) {
      const double angle = 2 * pi * i / 400 + 0.01;
      for (const double off : {-1e-6, 1e-6}) {
        const Vec3d p =
            Vec3d{50 + (r + off) * std::cos(angle), 40 + (r + off) * std::sin(angle), s.p.z} - s.p;
        EXPECT_EQ(trim_side(arrays, f, {dot(p, s.du), dot(p, s.dv)}) == TrimSide::inside, off > 0) << angle;
      }
    }
  }
  EXPECT_EQ(lids, 2U);
}

TEST(BrepTrim, whole_turns_of_a_periodic_parameter_change_nothing) {
  for (const TopoDS_Shape& shape :
       {step_shapes::tube(10, 8, 30), step_shapes::torus(20, 5), step_shapes::rounded_box(40, 30, 20, 4)}) {
    const Brep brep = brep_of(shape);
    const BrepView arrays = view(brep);
    std::mt19937 random(4);
    for (FaceId f = 0; f < brep.faces.size(); ++f) {
      const Surface& s = brep.surfaces[brep.faces[f].surface];
      for (int i = 0; i < 100; ++i) {
        const Parameters at = random_place(brep.faces[f], random);
        for (const double turns : {-2.0, -1.0, 1.0, 3.0}) {
          const Parameters other{at.u + turns * u_period(s), at.v + turns * v_period(s)};
          EXPECT_EQ(trim_side(arrays, f, other), trim_side(arrays, f, at)) << "face " << f;
        }
        const Parameters home = into_range(arrays, f, at);
        EXPECT_EQ(trim_side(arrays, f, home), trim_side(arrays, f, at));
      }
    }
  }
}

TEST(BrepTrim, the_share_of_a_face_that_is_inside_is_its_area) {
  const Brep brep = brep_of(plate_with_hole(20));
  const BrepView arrays = view(brep);
  std::mt19937 random(6);
  for (FaceId f = 0; f < brep.faces.size(); ++f) {
    const Face& face = brep.faces[f];
    const double whole = (face.range.u1 - face.range.u0) * (face.range.v1 - face.range.v0);
    if (std::fabs(whole - 8000) > 100) continue;  // the two lids
    std::uniform_real_distribution<double> share(0, 1);
    int inside = 0;
    constexpr int count = 20'000;
    for (int i = 0; i < count; ++i) {
      const Parameters at{face.range.u0 + share(random) * (face.range.u1 - face.range.u0),
                          face.range.v0 + share(random) * (face.range.v1 - face.range.v0)};
      inside += trim_side(arrays, f, at) == TrimSide::inside ? 1 : 0;
    }
    EXPECT_NEAR(whole * inside / count, 8000 - pi * 400, 120);  // four standard deviations
  }
}

}  // namespace
}  // namespace gabarit
