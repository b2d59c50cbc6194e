#include <cmath>
#include <functional>
#include <numbers>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipe.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gtest/gtest.h>

#include "checks/exact_probe.h"
#include "gpu/tangent_ball.h"
#include "model/brep_foot.h"
#include "tests/dense_boundary.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using step_shapes::loaded;
constexpr double wall = 120 * std::numbers::pi / 180;

class ExactSplineWalls : public step_shapes::StepFiles {};

// The same solid with rational splines for surfaces.
TopoDS_Shape as_splines(const TopoDS_Shape& shape) { return BRepBuilderAPI_NurbsConvert(shape).Shape(); }

// A wire of `thickness` wound about z: one and a half turns at `radius`, climbing by `pitch` a turn.
TopoDS_Shape helix(double radius, double pitch, double thickness) {
  const gp_Ax3 axes(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0));
  const double climb = pitch / (2 * std::numbers::pi), steep = std::hypot(1, climb);
  const Handle(Geom_CylindricalSurface) around = new Geom_CylindricalSurface(axes, radius);
  const Handle(Geom2d_Line) line = new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(1, climb));
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(line, around, 0., 3 * std::numbers::pi * steep);
  BRepLib::BuildCurves3d(edge);
  const gp_Ax2 start(gp_Pnt(radius, 0, 0), gp_Dir(0, radius, climb));
  const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(gp_Circ(start, thickness / 2));
  const TopoDS_Shape profile = BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(circle).Wire()).Shape();
  return BRepOffsetAPI_MakePipe(BRepBuilderAPI_MakeWire(edge).Wire(), profile).Shape();
}

// Every `stride`-th facet at its middle: `check(kind of its surface, place, wall)`.
void for_each_wall(const Model& model, std::size_t stride,
                   const std::function<void(SurfaceKind, const Vec3d& inward, const ExactWall&)>& check) {
  const Scene scene(model, Device::cpu(1));
  const ContactSurface& surface = scene.surface({.side = Side::inside, .crease = 0.7, .sag = *model.sag});
  const ExactWalls walls(scene, surface, {.side = Side::inside, .separation = wall});
  std::vector<FacetPlace> places;
  for (FacetId f = 0; f < model.mesh.facet_count(); f += static_cast<FacetId>(stride))
    places.push_back({f, {}});
  for (FacetPlace& place : places) place.weights = {1.0 / 3, 1.0 / 3};
  const std::vector<ExactWall> found = walls.measure(places);
  const BrepView arrays = view(*model.brep);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!found[i].measured) continue;
    const FacetOrigin& origin = model.brep->facets[places[i].facet];
    const Face& face = model.brep->faces[origin.face];
    const SurfacePoint s = face_point(arrays, face, parameters_at(origin, 1.0 / 3, 1.0 / 3, 1.0 / 3));
    check(arrays.surfaces[face.surface].kind, -outward_normal(s, face.sign), found[i]);
  }
}

// No point that counts of thousands on the boundary is nearer, by more than 1e-7 mm.
void expect_none_nearer(const Model& model, std::size_t stride) {
  const std::vector<BoundaryPoint> boundary = dense_boundary(*model.brep, 6000);
  std::size_t nearer = 0;
  for_each_wall(model, stride, [&](SurfaceKind, const Vec3d& inward, const ExactWall& w) {
    for (const auto& [p, n] : boundary) {
      const double away = length(p - w.at);
      if (dot(n, inward) < -std::cos(wall) || away < 1e-3) continue;
      nearer += 2 * ball_through_point(inward, p - w.at).radius < w.value - 1e-7 ? 1 : 0;
    }
  });
  EXPECT_EQ(nearer, 0U);
}

TEST_F(ExactSplineWalls, a_shell_of_splines_is_as_thick_as_its_radii_differ) {
  const Model model =
      loaded(step(as_splines(step_shapes::minus(step_shapes::sphere(10), step_shapes::sphere(8)))));
  std::size_t checked = 0;
  for_each_wall(model, 3, [&](SurfaceKind kind, const Vec3d&, const ExactWall& w) {
    if (kind != SurfaceKind::spline) return;
    EXPECT_NEAR(w.value, 2, 1e-7);
    ++checked;
  });
  EXPECT_GT(checked, 50U);
}

TEST_F(ExactSplineWalls, a_bent_pipe_of_splines_has_the_wall_it_was_given) {
  const Model model =
      loaded(step(as_splines(step_shapes::minus(step_shapes::torus(20, 5), step_shapes::torus(20, 3.5)))));
  std::size_t checked = 0;
  for_each_wall(model, 3, [&](SurfaceKind kind, const Vec3d&, const ExactWall& w) {
    if (kind != SurfaceKind::spline) return;
    EXPECT_NEAR(w.value, 1.5, 1e-7);
    ++checked;
  });
  EXPECT_GT(checked, 50U);
}

// The kernel's own sweep is a spline that follows the helix to some 1e-4 mm; along its section all points are
// equally near but for that.
TEST_F(ExactSplineWalls, a_helix_is_as_thick_as_its_wire) {
  const Model model = loaded(step(helix(10, 6, 2.4)));
  std::size_t checked = 0;
  for_each_wall(model, 7, [&](SurfaceKind kind, const Vec3d&, const ExactWall& w) {
    if (kind == SurfaceKind::plane) return;
    EXPECT_NEAR(w.value, 2.4, 2e-3);
    ++checked;
  });
  EXPECT_GT(checked, 50U);
  expect_none_nearer(model, 17);
}

}  // namespace
}  // namespace gabarit
