#include "model/brep_surface.h"

#include <numbers>
#include <random>

#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <gp_Pln.hxx>
#include <gtest/gtest.h>

#include "model/occt_surface.h"

namespace gabarit {
namespace {

const gp_Ax3 somewhere(gp_Pnt(3, -7, 11), gp_Dir(1, 2, -2), gp_Dir(2, 1, 0.3));

Vec3d vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
void expect_near(const Vec3d& ours, const gp_XYZ& theirs, double size, const char* what) {
  EXPECT_LT(length(ours - vec(theirs)), 1e-9 * (1 + size)) << what;
}

// At random parameters of the range: point and all first and second derivatives, relative to their size.
void expect_same(const Handle(Geom_Surface) & surface, const ParameterBox& range,
                 std::uint64_t approximated = 0) {
  Brep brep;
  const std::uint32_t number = add_surface(brep, surface, range);
  EXPECT_EQ(brep.approximated, approximated);
  const BrepView arrays = view(brep);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> in_u(range.u0, range.u1), in_v(range.v0, range.v1);
  for (int i = 0; i < 200; ++i) {
    const double u = in_u(random), v = in_v(random);
    gp_Pnt p;
    gp_Vec du, dv, duu, dvv, duv;
    surface->D2(u, v, p, du, dv, duu, dvv, duv);
    const SurfacePoint s = surface_point(arrays, brep.surfaces[number], u, v);
    expect_near(s.p, p.XYZ(), p.XYZ().Modulus(), "point");
    expect_near(s.du, du.XYZ(), du.Magnitude(), "du");
    expect_near(s.dv, dv.XYZ(), dv.Magnitude(), "dv");
    expect_near(s.duu, duu.XYZ(), duu.Magnitude(), "duu");
    expect_near(s.duv, duv.XYZ(), duv.Magnitude(), "duv");
    expect_near(s.dvv, dvv.XYZ(), dvv.Magnitude(), "dvv");
  }
}

Handle(Geom_BSplineSurface) rational_surface(int u_degree, int v_degree, int poles_u, int poles_v) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(0, 1);
  TColgp_Array2OfPnt poles(1, poles_u, 1, poles_v);
  TColStd_Array2OfReal weights(1, poles_u, 1, poles_v);
  for (int i = 1; i <= poles_u; ++i) {
    for (int j = 1; j <= poles_v; ++j) {
      poles(i, j) = gp_Pnt(10 * i + any(random), 7 * j + any(random), 5 * any(random));
      weights(i, j) = 0.5 + any(random);
    }
  }
  const auto knots = [](int degree, int count, TColStd_Array1OfReal& k, TColStd_Array1OfInteger& m) {
    for (int i = k.Lower(); i <= k.Upper(); ++i) k(i) = 0.3 * i * i, m(i) = 1;
    m(m.Lower()) = m(m.Upper()) = degree + 1;
    static_cast<void>(count);
  };
  TColStd_Array1OfReal u(1, poles_u - u_degree + 1), v(1, poles_v - v_degree + 1);
  TColStd_Array1OfInteger mu(1, u.Length()), mv(1, v.Length());
  knots(u_degree, poles_u, u, mu);
  knots(v_degree, poles_v, v, mv);
  return new Geom_BSplineSurface(poles, weights, u, v, mu, mv, u_degree, v_degree);
}

Handle(Geom_BSplineCurve) spline_curve() {
  TColgp_Array1OfPnt poles(1, 5);
  TColStd_Array1OfReal weights(1, 5), knots(1, 3);
  TColStd_Array1OfInteger multiplicities(1, 3);
  for (int i = 1; i <= 5; ++i) poles(i) = gp_Pnt(20 + 3 * i, i % 2, 4 * i), weights(i) = 1 + 0.1 * i;
  for (int i = 1; i <= 3; ++i) knots(i) = i, multiplicities(i) = i == 2 ? 1 : 4;
  return new Geom_BSplineCurve(poles, weights, knots, multiplicities, 3);
}

constexpr ParameterBox turn{-1, 7, -1.4, 1.4};

TEST(BrepSurface, planes_and_quadrics_agree_with_opencascade) {
  expect_same(new Geom_Plane(somewhere), turn);
  expect_same(new Geom_CylindricalSurface(somewhere, 4), turn);
  expect_same(new Geom_ConicalSurface(somewhere, 0.3, 4), turn);
  expect_same(new Geom_SphericalSurface(somewhere, 4), turn);
  expect_same(new Geom_ToroidalSurface(somewhere, 9, 4), turn);
}

TEST(BrepSurface, mirrored_surfaces_agree_with_opencascade) {
  gp_Ax3 mirrored = somewhere;
  mirrored.YReverse();
  ASSERT_FALSE(mirrored.Direct());
  expect_same(new Geom_CylindricalSurface(mirrored, 4), turn);
  expect_same(new Geom_ToroidalSurface(mirrored, 9, 4), turn);
}

TEST(BrepSurface, splines_of_any_degree_agree_with_opencascade) {
  for (const auto& [u, v] : {std::pair{1, 1}, {2, 3}, {3, 3}, {5, 2}, {9, 4}}) {
    const Handle(Geom_BSplineSurface) s = rational_surface(u, v, u + 4, v + 3);
    ParameterBox range;
    s->Bounds(range.u0, range.u1, range.v0, range.v1);
    expect_same(s, range);
  }
}

TEST(BrepSurface, periodic_splines_agree_with_opencascade_in_every_turn) {
  Handle(Geom_BSplineSurface) s = rational_surface(3, 3, 9, 6);
  for (int j = 1; j <= 6; ++j) s->SetPole(9, j, s->Pole(1, j)), s->SetWeight(9, j, s->Weight(1, j));
  s->SetUPeriodic();
  ASSERT_TRUE(s->IsUPeriodic());
  ParameterBox range;
  s->Bounds(range.u0, range.u1, range.v0, range.v1);
  range.u1 += 1.5 * (range.u1 - range.u0);
  expect_same(s, range);
}

TEST(BrepSurface, periodic_splines_without_weights_agree_with_opencascade) {
  constexpr int around = 8, along = 4;
  TColgp_Array2OfPnt poles(1, around, 1, along);
  for (int i = 1; i <= around; ++i) {
    const double angle = i * 2 * std::numbers::pi / around;
    for (int j = 1; j <= along; ++j)
      poles(i, j) = gp_Pnt((10 + j % 2) * std::cos(angle), 10 * std::sin(angle), 7 * j);
  }
  TColStd_Array1OfReal u(1, around + 1), v(1, 2);
  TColStd_Array1OfInteger mu(1, around + 1), mv(1, 2);
  for (int i = 1; i <= around + 1; ++i) u(i) = i, mu(i) = 1;
  v(1) = 0, v(2) = 1, mv(1) = mv(2) = 4;
  for (const bool along_u : {true, false}) {
    const Handle(Geom_BSplineSurface) s = new Geom_BSplineSurface(poles, u, v, mu, mv, 3, 3, true, false);
    if (!along_u) s->ExchangeUV();
    ASSERT_FALSE(s->IsURational() || s->IsVRational());
    ParameterBox range;
    s->Bounds(range.u0, range.u1, range.v0, range.v1);
    expect_same(s, range);
  }
}

TEST(BrepSurface, extrusions_and_revolutions_agree_with_opencascade_on_every_kind_of_curve) {
  const gp_Ax2 at(gp_Pnt(20, 0, 1), gp_Dir(0, 1, 0));
  const gp_Ax1 axis(gp_Pnt(1, 2, 3), gp_Dir(0, 0.1, 1));
  for (const Handle(Geom_Curve) & curve :
       {Handle(Geom_Curve)(new Geom_Line(gp_Pnt(20, 0, 1), gp_Dir(0.2, 0, 1))),
        Handle(Geom_Curve)(new Geom_Circle(at, 4)), Handle(Geom_Curve)(new Geom_Ellipse(at, 4, 2)),
        Handle(Geom_Curve)(new Geom_Hyperbola(at, 4, 2)), Handle(Geom_Curve)(new Geom_Parabola(at, 2)),
        Handle(Geom_Curve)(spline_curve()),
        Handle(Geom_Curve)(new Geom_TrimmedCurve(new Geom_Circle(at, 4), 0.2, 2.8))}) {
    expect_same(new Geom_SurfaceOfLinearExtrusion(curve, gp_Dir(0, 1, 0.2)), {1.1, 2.7, -3, 3});
    expect_same(new Geom_SurfaceOfRevolution(curve, axis), {-1, 7, 1.1, 2.7});
  }
}

TEST(BrepSurface, bezier_and_trimmed_surfaces_keep_their_parameters) {
  TColgp_Array2OfPnt poles(1, 4, 1, 3);
  for (int i = 1; i <= 4; ++i) {
    for (int j = 1; j <= 3; ++j) poles(i, j) = gp_Pnt(5 * i, 6 * j, i * j % 3);
  }
  expect_same(new Geom_BezierSurface(poles), {0, 1, 0, 1});
  expect_same(
      new Geom_RectangularTrimmedSurface(new Geom_SphericalSurface(somewhere, 4), 0.5, 2.5, -1.0, 1.0),
      {0.5, 2.5, -1, 1});
}

// Only the offsets of what has no simpler form are approximated, and counted.
TEST(BrepSurface, offsets_of_quadrics_are_quadrics_and_others_are_close) {
  expect_same(new Geom_OffsetSurface(new Geom_SphericalSurface(somewhere, 4), 1), turn);
  const Handle(Geom_Surface) offset = new Geom_OffsetSurface(rational_surface(3, 3, 5, 5), 0.5);
  ParameterBox range;
  offset->Bounds(range.u0, range.u1, range.v0, range.v1);
  Brep brep;
  const std::uint32_t number = add_surface(brep, offset, range);
  EXPECT_EQ(brep.approximated, 1U);
  EXPECT_LT(brep.approximation_error, 1e-3);
  const BrepView arrays = view(brep);
  for (int i = 0; i <= 20; ++i) {
    const double u = range.u0 + i * (range.u1 - range.u0) / 20, v = range.v1 - i * (range.v1 - range.v0) / 20;
    EXPECT_LT(length(surface_point(arrays, brep.surfaces[number], u, v).p - vec(offset->Value(u, v).XYZ())),
              std::max(1e-6, 2 * brep.approximation_error));
  }
}

}  // namespace
}  // namespace gabarit
