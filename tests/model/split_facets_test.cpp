#include "model/split_facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "model/brep_surface.h"
#include "model/brep_view.h"
#include "tests/step_shapes.h"

namespace gabarit {
namespace {

using step_shapes::loaded;
using step_shapes::volume;
using testing::HasSubstr;
constexpr double pi = std::numbers::pi;

class SplitFacets : public step_shapes::StepFiles {
 protected:
  Model with_facets_of(double size, const TopoDS_Shape& shape, double sag = 0.05) const {
    LoadOptions options;
    options.sag = sag;
    options.facet_size = size;
    return loaded(step(shape), options);
  }
};

double longest_side(const TriangleMesh& mesh) {
  double longest = 0;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i)
      longest = std::max(longest, length(mesh.corner(f, (i + 1) % 3) - mesh.corner(f, i)));
  }
  return longest;
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) sum += facet_area(mesh, f);
  return sum;
}

TopoDS_Shape plate_with_a_hole() {
  return step_shapes::minus(step_shapes::box(40, 40, 5),
                            step_shapes::moved(step_shapes::cylinder(8, 20), 20, 18, -5));
}

TEST_F(SplitFacets, no_side_is_longer_the_mesh_stays_closed_and_every_corner_on_its_face) {
  for (const TopoDS_Shape& shape :
       {step_shapes::tube(10, 8, 30), step_shapes::sphere(10), step_shapes::torus(20, 5),
        step_shapes::cone(10, 20), step_shapes::rounded_box(40, 30, 20, 4), plate_with_a_hole()}) {
    const Model model = with_facets_of(2.5, shape);
    EXPECT_LE(longest_side(model.mesh), 2.5);
    EXPECT_TRUE(watertight(model.defects));
    EXPECT_EQ(model.defects.misoriented_edges, 0U);
    ASSERT_EQ(model.brep->facets.size(), model.mesh.facet_count());
    const BrepView brep = view(*model.brep);
    for (FacetId f = 0; f < model.mesh.facet_count(); ++f) {
      const FacetOrigin& origin = model.brep->facets[f];
      for (int i = 0; i < 3; ++i) {
        const Parameters at = origin.corners[static_cast<std::size_t>(i)];
        const Vec3d p = face_point(brep, model.brep->faces[origin.face], at).p;
        EXPECT_LT(length(p - model.mesh.corner(f, i)), 1e-6);
      }
    }
  }
}

TEST_F(SplitFacets, planes_keep_their_area_and_round_parts_come_nearer_to_their_volume) {
  const TopoDS_Shape box = step_shapes::box(10, 20, 30);
  EXPECT_NEAR(area(with_facets_of(1.3, box).mesh), 2200, 1e-9);
  EXPECT_NEAR(volume(with_facets_of(1.3, box)), 6000, 1e-9);
  const double exact = 4.0 / 3 * pi * 1000;
  const double coarse = exact - volume(with_facets_of(100, step_shapes::sphere(10), 0.5));
  const double fine = exact - volume(with_facets_of(1, step_shapes::sphere(10), 0.5));
  EXPECT_GT(fine, 0);
  EXPECT_LT(fine, coarse / 4);
}

TEST_F(SplitFacets, new_vertices_between_two_faces_lie_on_their_edge) {
  const Model model = with_facets_of(1, plate_with_a_hole(), 0.3);
  std::size_t on_rim = 0;
  for (const Vec3d& p : model.mesh.vertices) {
    if (std::abs(p.z - 5) > 1e-9 || std::hypot(p.x - 20, p.y - 18) > 8.2) continue;
    EXPECT_NEAR(std::hypot(p.x - 20, p.y - 18), 8, 1e-9);
    ++on_rim;
  }
  EXPECT_GE(on_rim, 51U);  // round the rim of 50.3 mm
}

TEST_F(SplitFacets, it_moves_with_the_part_and_gives_the_same_facets_again) {
  const TopoDS_Shape tube = step_shapes::tube(10, 8, 30);
  const Model one = with_facets_of(2, tube), again = with_facets_of(2, tube);
  EXPECT_EQ(one.mesh.vertices, again.mesh.vertices);
  EXPECT_EQ(one.mesh.facets, again.mesh.facets);
  const Model there = with_facets_of(2, step_shapes::moved(step_shapes::turned(tube, 33), 300, -200, 50));
  EXPECT_LE(longest_side(there.mesh), 2);
  EXPECT_NEAR(area(there.mesh), area(one.mesh), 1e-3 * area(one.mesh));
}

TEST_F(SplitFacets, a_size_that_asks_for_too_many_facets_is_given_up_without_opening_the_mesh) {
  Model model = with_facets_of(100, plate_with_a_hole());
  const std::size_t before = model.mesh.facet_count();
  EXPECT_FALSE(split_facets(*model.brep, 0.01, 20'000, 0, model.mesh, model.brep->facets));
  EXPECT_GT(model.mesh.facet_count(), before);
  EXPECT_LE(model.mesh.facet_count(), 20'000U);
  EXPECT_TRUE(watertight(count_defects(model.mesh)));
}

TEST_F(SplitFacets, facets_of_a_mesh_file_stay_as_they_are) {
  LoadOptions options;
  options.facet_size = 1;
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 50 0 0\nvertex 0 50 0\nendloop\nendfacet\n";
  const Model model = loaded(text("one.stl", "solid one\n" + facet + "endsolid one\n"), options);
  EXPECT_EQ(model.mesh.facet_count(), 1U);
  ASSERT_EQ(model.warnings.size(), 1U);
  EXPECT_THAT(model.warnings[0].message, HasSubstr("stay as they are"));
}

}  // namespace
}  // namespace gabarit
