// Mirrored bodies read the same as their originals: normals, inside and outside, walls and radii.
#include <BRepBuilderAPI_Transform.hxx>
#include <gmock/gmock.h>
#include <gp_Ax2.hxx>

#include "checks/radius_exact.h"
#include "model/brep_curvature.h"
#include "model/brep_trim.h"
#include "tests/checks/wall_fields.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using step_shapes::loaded;
using step_shapes::volume;

class Mirrored : public step_shapes::StepFiles {};

gp_Trsf mirror() {
  gp_Trsf t;
  t.SetMirror(gp_Ax2({3, 4, 5}, {0.6, 0.48, 0.64}));
  return t;
}
TopoDS_Shape mirrored(const TopoDS_Shape& shape) {
  return BRepBuilderAPI_Transform(shape, mirror(), Standard_True);
}

// Outer fillets of R3, a bore of R4 whose rim is sharp; and every other kind of surface.
std::vector<TopoDS_Shape> solids() {
  const TopoDS_Shape bored = step_shapes::minus(
      step_shapes::rounded_box(40, 30, 20, 3), step_shapes::moved(step_shapes::cylinder(4, 60), 12, 17, -10));
  return {bored,
          step_shapes::as_splines(bored),
          step_shapes::torus(20, 5),
          step_shapes::cone(10, 20),
          step_shapes::sphere(7),
          step_shapes::tube(10, 8, 30),
          step_shapes::elliptic_cylinder(10, 6, 30),
          step_shapes::lobed_cylinder({10, 7, 10, 8, 10, 7}, 20),
          step_shapes::prism({{0, 0}, {40, 0}, {5, 8}}, 10)};
}

void expect_sound(const Model& model) {
  const Brep& brep = *model.brep;
  const BrepView arrays = view(brep);
  EXPECT_TRUE(watertight(model.defects));
  EXPECT_GT(volume(model), 0);
  for (FacetId f = 0; f < model.mesh.facet_count(); ++f) {
    const FacetOrigin& origin = brep.facets[f];
    const Face& face = brep.faces[origin.face];
    const Parameters at = parameters_at(origin, 1 / 3., 1 / 3., 1 / 3.);
    EXPECT_GT(dot(outward_normal(face_point(arrays, face, at), face.sign), facet_normal(model.mesh, f)), 0.7);
    EXPECT_EQ(trim_side(arrays, origin.face, at), TrimSide::inside);
  }
}

// Smallest and greatest finite ones, and how much of the area is below some limits.
struct Summary {
  double least = 1e9, greatest = 0;
  std::array<double, 3> below{};
};
Summary summary(const Model& model, const Field& field) {
  Summary s;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (!std::isfinite(field.value[i])) continue;
    s.least = std::min(s.least, field.value[i]), s.greatest = std::max(s.greatest, field.value[i]);
    const auto [a, b, c] = model.mesh.corners(field.facets[i]);
    for (std::size_t k = 0; k < 3; ++k)
      s.below[k] += field.value[i] < std::array{1.0, 3.5, 6.0}[k] ? length(cross(b - a, c - a)) / 2 : 0;
  }
  return s;
}

Field radius(const Model& model) {
  return measure_exact_radius(Scene(model, Device::cpu()), whole_model(model.mesh));
}

void expect_same(const Model& a, const Model& b) {
  EXPECT_NEAR(volume(a), volume(b), 1e-3 * volume(a));
  const Summary x = summary(a, radius(a)), y = summary(b, radius(b));
  EXPECT_NEAR(x.least, y.least, 1e-3 * x.least + 2e-6);
  EXPECT_NEAR(x.greatest, y.greatest, 0.02 * x.greatest);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(x.below[k], y.below[k], 0.12 * x.below[2] + 1e-6);
  for (const EdgeKind kind : {EdgeKind::convex, EdgeKind::concave, EdgeKind::smooth}) {
    const auto count = [&](const Model& m) {
      return std::count_if(m.brep->edges.begin(), m.brep->edges.end(),
                           [&](const Edge& e) { return e.kind == kind; });
    };
    EXPECT_EQ(count(a), count(b)) << name(kind);
  }
}

TEST_F(Mirrored, walls_of_a_mirrored_solid_are_as_thick) {
  const TopoDS_Shape tube = step_shapes::tube(10, 8, 30);
  for (const TopoDS_Shape& shape : {tube, step_shapes::as_splines(tube)}) {
    const Field field = measure(thickness_measure, loaded(step(mirrored(shape))), at_least(2.01));
    EXPECT_NEAR(least_value(field), 2, 1e-5);
    EXPECT_TRUE(fails(field, 2.01));
    EXPECT_TRUE(passes(field, 1.99));
  }
}

// A file of an assembly whose second component is placed by an operator that mirrors at the plane x = 0.
TEST_F(Mirrored, a_component_that_its_assembly_mirrors_reads_as_its_original) {
  const TopoDS_Shape shape = solids().front();
  std::string content =
      step_shapes::text_of(assembly({{"part", shape}, {"part", step_shapes::moved(shape, 100, 0, 0)}}));
  const std::size_t at = content.rfind("ITEM_DEFINED_TRANSFORMATION");
  ASSERT_NE(at, std::string::npos);
  content.replace(at, content.find(';', at) - at,
                  "CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',#900001,#900002,#900004,1.,#900003)");
  content.insert(content.rfind("ENDSEC;"),
                 "#900001=DIRECTION('',(-1.,0.,0.));\n#900002=DIRECTION('',(0.,1.,0.));\n"
                 "#900003=DIRECTION('',(0.,0.,1.));\n#900004=CARTESIAN_POINT('',(-10.,0.,0.));\n");
  const Model model = loaded(text("mirrored.stp", content));
  ASSERT_EQ(model.bodies.size(), 2U);
  expect_sound(model);
  EXPECT_NEAR(volume(model), 2 * volume(loaded(step(shape))), 1e-3 * volume(model));
  Box3d image;
  for (FacetId f = 0; f < model.mesh.facet_count(); ++f) {
    if (model.mesh.body_of(f) != 1) continue;
    for (const Vec3d& corner : model.mesh.corners(f)) image.add(corner);
  }
  EXPECT_NEAR(image.max.x, -10, 1e-6);
  EXPECT_NEAR(image.min.x, -50, 1e-6);
}

TEST_F(Mirrored, a_solid_with_a_mirrored_shape_reads_as_its_original) {
  for (const TopoDS_Shape& shape : solids()) {
    const Model original = loaded(step(shape)), image = loaded(step(mirrored(shape)));
    expect_sound(image);
    expect_same(original, image);
  }
}

}  // namespace
}  // namespace gabarit
