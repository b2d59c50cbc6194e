#include "model/triangle_mesh.h"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

double surface(const TriangleMesh& mesh) {
  double area = 0;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) area += facet_area(mesh, f);
  return area;
}

// Positive when the facets face outwards.
double volume(const TriangleMesh& mesh) {
  double six = 0;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const auto [a, b, c] = mesh.corners(f);
    six += dot(a, cross(b, c));
  }
  return six / 6;
}

TEST(TriangleMesh, test_shapes_face_outwards_and_have_the_right_size) {
  EXPECT_DOUBLE_EQ(surface(shapes::mesh(shapes::box({0, 0, 0}, {1, 2, 3}))), 22);
  EXPECT_DOUBLE_EQ(volume(shapes::mesh(shapes::gridded_box({0, 0, 0}, {1, 2, 3}, 0.5))), 6);
  EXPECT_DOUBLE_EQ(volume(shapes::mesh(shapes::extrude({{0, 0}, {4, 0}, {0, 3}}, -1, 1, 3))), 12);
  EXPECT_NEAR(volume(shapes::mesh(shapes::sphere(2, 200, 200))), 4.0 / 3 * std::numbers::pi * 8, 0.02);
  EXPECT_NEAR(volume(shapes::mesh(shapes::torus(5, 1, 300, 200))),
              2 * std::numbers::pi * std::numbers::pi * 5, 0.05);
}

TEST(TriangleMesh, a_facet_without_area_has_no_normal) {
  const TriangleMesh mesh =
      shapes::mesh({{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}},
                    {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                    {{{0, 0, 0}, {1e30, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}}}});
  EXPECT_EQ(facet_normal(mesh, 0), Vec3d{});
  EXPECT_EQ(facet_normal(mesh, 1), (Vec3d{0, 0, 1}));
  EXPECT_EQ(facet_normal(mesh, 2), Vec3d{});
  EXPECT_EQ(facet_area(mesh, 2), 0.0);
}

}  // namespace
}  // namespace gabarit
