#include "model/brep_trim.h"

#include <numbers>
#include <random>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepClass_FaceClassifier.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Elips.hxx>
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
  EXPECT_EQ(brep.trims.size(), brep.faces.size());
  EXPECT_EQ(brep.untrimmed, 0U);
  EXPECT_EQ(brep.leaky, 0U);
  return brep;
}

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Face> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    faces.push_back(TopoDS::Face(it.Current()));
  return faces;
}

bool inside(const Brep& brep, FaceId face, double u, double v) {
  return trim_side(view(brep), face, {u, v}) == TrimSide::inside;
}

// The face of the one surface of that kind.
FaceId only(const Brep& brep, SurfaceKind kind) {
  FaceId found = no_number;
  for (FaceId f = 0; f < brep.faces.size(); ++f) {
    if (brep.surfaces[brep.faces[f].surface].kind != kind) continue;
    EXPECT_EQ(found, no_number);
    found = f;
  }
  return found;
}

TopoDS_Face face_within(const TopoDS_Edge& edge) {
  return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(edge).Wire()).Face();
}
TopoDS_Shape swept(const TopoDS_Face& face) { return BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, 10)).Shape(); }

// Closed, with five waves.
TopoDS_Face within_a_spline() {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 40);
  for (int i = 1; i <= 40; ++i) {
    const double a = 2 * pi * i / 40, r = 20 + 4 * std::sin(5 * a);
    points->SetValue(i, gp_Pnt(r * std::cos(a), r * std::sin(a), 0));
  }
  GeomAPI_Interpolate spline(points, Standard_True, 1e-9);
  spline.Perform();
  return face_within(BRepBuilderAPI_MakeEdge(spline.Curve()).Edge());
}

TopoDS_Shape bored(double at_degrees) {
  gp_Trsf turn;
  turn.SetRotation(gp::OZ(), at_degrees * pi / 180);
  const gp_Ax2 across(gp_Pnt(0, 0, 20), gp_Dir(1, 0, 0));
  const TopoDS_Shape bore = BRepPrimAPI_MakeCylinder(across, 4, 30).Shape();
  return step_shapes::minus(step_shapes::tube(10, 8, 40), bore.Moved(turn));
}

// A strip 2 mm wide that climbs 30 mm in three turns on a cylinder of R5.
TopoDS_Face thread() {
  const Handle(Geom_CylindricalSurface) surface = new Geom_CylindricalSurface(gp_Ax3(gp::XOY()), 5);
  const std::array<gp_Pnt2d, 4> corners{gp_Pnt2d(0, 0), gp_Pnt2d(6 * pi, 30), gp_Pnt2d(6 * pi, 32),
                                        gp_Pnt2d(0, 2)};
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < 4; ++i) {
    const gp_Pnt2d a = corners[i], b = corners[(i + 1) % 4];
    const Handle(Geom2d_Line) line = new Geom2d_Line(a, gp_Dir2d(gp_Vec2d(a, b)));
    wire.Add(BRepBuilderAPI_MakeEdge(line, surface, 0, a.Distance(b)).Edge());
  }
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, wire.Wire()).Face();
  BRepLib::BuildCurves3d(face);
  return face;
}

struct NamedSolid {
  const char* name;
  TopoDS_Shape shape;
};
std::vector<NamedSolid> solids() {
  const TopoDS_Face ellipse = face_within(BRepBuilderAPI_MakeEdge(gp_Elips(gp::XOY(), 20, 7)).Edge());
  return {
      {"box", step_shapes::box(10, 20, 30)},
      {"rounded box", step_shapes::rounded_box(40, 30, 20, 4)},
      {"plate with hole", step_shapes::minus(step_shapes::box(40, 40, 5),
                                             step_shapes::moved(step_shapes::cylinder(7, 5), 20, 21, 0))},
      {"cylinder", step_shapes::cylinder(10, 20)},
      {"part of a cylinder", BRepPrimAPI_MakeCylinder(10, 20, 4.5).Shape()},
      {"sphere", step_shapes::sphere(10)},
      {"part of a sphere", BRepPrimAPI_MakeSphere(10, -0.3, 1.1, 5).Shape()},
      {"torus", step_shapes::torus(20, 5)},
      {"bend", BRepPrimAPI_MakeTorus(20, 5, pi / 2).Shape()},
      {"cone", step_shapes::cone(10, 20)},
      {"part of a cone", BRepPrimAPI_MakeCone(10, 4, 20, 1).Shape()},
      {"elliptic prism", swept(ellipse)},
      {"splined prism", swept(within_a_spline())},
      {"cylinder cut aslant",
       step_shapes::minus(
           step_shapes::cylinder(10, 40),
           step_shapes::moved(step_shapes::turned(step_shapes::box(60, 60, 60), 30), -30, -30, 30))},
      {"bored tube", bored(90)},
      {"tube bored through its seam", bored(0)},
      {"cut ball", step_shapes::minus(step_shapes::sphere(10),
                                      step_shapes::moved(step_shapes::cylinder(3, 30), 4, 1, -15))},
      {"cut torus", step_shapes::minus(step_shapes::torus(20, 6),
                                       step_shapes::moved(step_shapes::box(9, 9, 9), 17, -4, -3))},
  };
}

// All in one turn. Within OpenCASCADE's tolerance of a curve nothing is compared.
void expect_same_side(const TopoDS_Face& face, const Brep& brep, FaceId id, int points) {
  const ParameterBox& b = brep.trims[id].box;
  const Surface& s = brep.surfaces[brep.faces[id].surface];
  std::mt19937 random(id + 1);
  std::uniform_real_distribution<double> u(b.u0, b.u1), v(b.v0, b.v1);
  for (int i = 0; i < points; ++i) {
    const gp_Pnt2d at(u(random), v(random));
    const TopAbs_State theirs = BRepClass_FaceClassifier(face, at, 1e-7).State();
    if (theirs == TopAbs_ON) continue;
    for (const int turn : {0, 1, -2}) {
      const bool ours = inside(brep, id, at.X() + turn * u_period(s), at.Y() + turn * v_period(s));
      EXPECT_EQ(ours, theirs == TopAbs_IN)
          << name(s.kind) << " " << at.X() << ", " << at.Y() << " turn " << turn;
    }
  }
}

TEST(BrepTrim, every_kind_of_face_agrees_with_opencascade_at_random_points_in_any_turn) {
  for (const NamedSolid& solid : solids()) {
    SCOPED_TRACE(solid.name);
    const Brep brep = brep_of(solid.shape);
    const std::vector<TopoDS_Face> faces = faces_of(solid.shape);
    for (FaceId f = 0; f < faces.size(); ++f) expect_same_side(faces[f], brep, f, 300);
  }
}

TEST(BrepTrim, faces_seen_from_behind_and_moved_ones_have_the_same_trimming) {
  gp_Trsf askew;
  askew.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0.2)), 0.7);
  for (const NamedSolid& solid : solids()) {
    SCOPED_TRACE(solid.name);
    for (const TopoDS_Shape& shape : {solid.shape.Reversed(), solid.shape.Moved(askew)}) {
      const Brep brep = brep_of(shape);
      const std::vector<TopoDS_Face> faces = faces_of(shape);
      for (FaceId f = 0; f < faces.size(); ++f) expect_same_side(faces[f], brep, f, 40);
    }
  }
}

// The sum over a grid of the range, in mm².
double area_inside(const Brep& brep, FaceId f) {
  constexpr int steps = 150;
  const Face& face = brep.faces[f];
  const ParameterBox& r = face.range;
  double area = 0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const Parameters at{r.u0 + (r.u1 - r.u0) * (i + 0.5) / steps, r.v0 + (r.v1 - r.v0) * (j + 0.5) / steps};
      const SurfacePoint p = face_point(view(brep), face, at);
      if (inside(brep, f, at.u, at.v)) area += length(cross(p.du, p.dv));
    }
  }
  return area * (r.u1 - r.u0) * (r.v1 - r.v0) / (steps * steps);
}

TEST(BrepTrim, what_lies_inside_has_the_area_of_the_face) {
  for (const NamedSolid& solid : solids()) {
    const Brep brep = brep_of(solid.shape);
    const std::vector<TopoDS_Face> faces = faces_of(solid.shape);
    for (FaceId f = 0; f < faces.size(); ++f) {
      GProp_GProps properties;
      BRepGProp::SurfaceProperties(faces[f], properties);
      EXPECT_NEAR(area_inside(brep, f) / properties.Mass(), 1, 0.03) << solid.name << " face " << f;
    }
  }
}

// With 32 chords for the circle, points 0.15 mm inside the hole would count as material.
TEST(BrepTrim, a_millionth_of_a_millimetre_decides_beside_a_hole_of_r31_5) {
  const TopoDS_Shape plate = step_shapes::minus(
      step_shapes::box(100, 100, 5), step_shapes::moved(step_shapes::cylinder(31.5, 5), 50, 50, 0));
  const Brep brep = brep_of(plate);
  for (FaceId f = 0; f < brep.faces.size(); ++f) {
    const Surface& s = brep.surfaces[brep.faces[f].surface];
    if (s.kind != SurfaceKind::plane || std::abs(s.axes.z.z) < 0.5) continue;
    for (int i = 0; i < 1000; ++i) {
      const double a = 0.0063 * i;
      for (const double off : {-1e-6, -1e-9, 1e-9, 1e-6}) {
        const Vec3d p =
            Vec3d{50 + (31.5 + off) * std::cos(a), 50 + (31.5 + off) * std::sin(a), s.axes.origin.z};
        const Vec3d d = p - s.axes.origin;
        EXPECT_EQ(inside(brep, f, dot(d, s.axes.x), dot(d, s.axes.y)), off > 0) << a << " " << off;
      }
    }
  }
}

TEST(BrepTrim, a_spline_is_followed_to_the_last_digits) {
  const TopoDS_Face face = within_a_spline();
  const Brep brep = brep_of(face);
  const Curve& c = brep.curves[brep.edges[0].curve];
  ASSERT_EQ(c.kind, CurveKind::spline);
  const Surface& s = brep.surfaces[0];
  for (int i = 0; i < 500; ++i) {
    const CurvePoint p = curve_point(view(brep), c, c.first + (c.last - c.first) * i / 500);
    const Vec3d out = normalized(cross(p.d, Vec3d{0, 0, 1}));  // the curve runs counter-clockwise
    for (const double off : {-1e-6, -1e-9, 1e-9, 1e-6}) {
      const Vec3d d = p.p + out * off - s.axes.origin;
      EXPECT_EQ(inside(brep, 0, dot(d, s.axes.x), dot(d, s.axes.y)), off < 0) << i << " " << off;
    }
  }
}

// Where a sum of angles ends up beside a seam is a matter of rounding.
TEST(BrepTrim, no_point_falls_through_a_seam_or_a_pole) {
  const Brep cylinder = brep_of(step_shapes::cylinder(10, 20));
  const Brep sphere = brep_of(step_shapes::sphere(10)), torus = brep_of(step_shapes::torus(20, 5));
  for (const double turn : {0.0, 2 * pi, -2 * pi, 200 * pi}) {
    for (const double off : {0.0, 5e-324, -5e-324, 1e-17, -1e-17, 4e-16, -4e-16, 1e-12, -1e-12}) {
      EXPECT_TRUE(inside(cylinder, only(cylinder, SurfaceKind::cylinder), turn + off, 7))
          << turn << " " << off;
      EXPECT_TRUE(inside(sphere, 0, turn + off, 0.2)) << turn << " " << off;
      EXPECT_TRUE(inside(torus, 0, turn + off, turn + off)) << turn << " " << off;
      EXPECT_TRUE(inside(torus, 0, 1, turn + off)) << turn << " " << off;
    }
    EXPECT_TRUE(inside(sphere, 0, turn + 1, pi / 2));
    EXPECT_TRUE(inside(sphere, 0, turn + 1, -pi / 2));
  }
}

TEST(BrepTrim, a_thread_of_three_turns_is_known_in_every_turn) {
  const Brep brep = brep_of(thread());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(-20, 40), v(-1, 33);
  int found = 0;
  for (int i = 0; i < 5000; ++i) {
    const double at_u = u(random), at_v = v(random);
    bool truth = false;
    for (int turn = -8; turn <= 8; ++turn) {
      const double t = at_u + 2 * pi * turn, above = at_v - t * 30 / (6 * pi);
      truth = truth || (t > 0 && t < 6 * pi && above > 0 && above < 2);
    }
    EXPECT_EQ(inside(brep, 0, at_u, at_v), truth) << at_u << ", " << at_v;
    found += truth ? 1 : 0;
  }
  EXPECT_GT(found, 500);
}

TEST(BrepTrim, parameters_come_into_the_range_of_their_face) {
  const Brep brep = brep_of(BRepPrimAPI_MakeCylinder(10, 20, 4.5).Shape());
  const FaceId f = only(brep, SurfaceKind::cylinder);
  for (const double turn : {-4 * pi, 0.0, 2 * pi}) {
    EXPECT_NEAR(into_range(view(brep), f, {3 + turn, 7}).u, 3, 1e-12);
    EXPECT_NEAR(into_range(view(brep), f, {4.6 + turn, 7}).u, 4.6, 1e-12);
    EXPECT_NEAR(into_range(view(brep), f, {-0.1 + turn, 7}).u, -0.1, 1e-12);
  }
  EXPECT_EQ(into_range(view(brep), f, {3, 99}).v, 99);
}

TEST(BrepTrim, every_face_knows_its_edges_once) {
  const Brep brep = brep_of(step_shapes::cylinder(10, 20));
  ASSERT_EQ(brep.first_edge_of_face.size(), 4U);
  std::vector<std::uint32_t> counts;
  for (std::size_t f = 0; f < 3; ++f)
    counts.push_back(brep.first_edge_of_face[f + 1] - brep.first_edge_of_face[f]);
  EXPECT_EQ(counts, (std::vector<std::uint32_t>{3, 1, 1}));
  for (const EdgeId e : brep.edges_of_face) EXPECT_LT(e, brep.edges.size());
}

}  // namespace
}  // namespace gabarit
