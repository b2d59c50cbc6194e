#include "checks/radius.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checks/hidden_rounding.h"
#include "checks/turning.h"
#include "tests/checks/fillets.h"
#include "tests/checks/turning_field.h"
#include "tests/shapes.h"

namespace gabarit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

void expect_bounds(const Field& field, double radius) {
  for (std::size_t i = 0; i < field.size(); ++i) {
    EXPECT_LE(field.lower[i], radius * (1 + 1e-9)) << "facet " << i;
    EXPECT_GE(field.upper[i], radius * (1 - 1e-9)) << "facet " << i;
  }
}

TEST(Radius, every_facet_of_a_box_touches_a_sharp_edge) {
  const Field field = measured(shapes::box({0, 0, 0}, {300, 200, 100}));
  ASSERT_EQ(field.size(), 12U);
  for (std::size_t i = 0; i < field.size(); ++i) {
    EXPECT_EQ(field.value[i], 0);
    EXPECT_EQ(field.lower[i], 0);
    EXPECT_NEAR(field.upper[i], 0.1 / (1 - std::cos(pi / 4)), 1e-6);
  }
}

TEST(Radius, a_sharp_edge_fails_r4_on_facets_of_any_size_and_shape) {
  for (const double step : {0.05, 0.3, 1.0, 5.0, 40.0}) {
    const double size = std::min(40.0, 12 * step);
    const auto triangles = shapes::gridded_box({0, 0, 0}, {size, size, size}, step);
    const Field field = measured(triangles);
    const TriangleMesh mesh = shapes::mesh(triangles);
    for (FacetId f = 0; f < mesh.facet_count(); ++f) {
      for (int e = 0; e < 3; ++e) {
        int outer = 0;  // coordinates that both ends have at their least or greatest
        for (int axis = 0; axis < 3; ++axis) {
          const double x = mesh.corner(f, e)[axis];
          outer += x == mesh.corner(f, (e + 1) % 3)[axis] && (x == 0 || x == size);
        }
        if (outer == 2) {
          EXPECT_LT(field.upper[f], 4) << "step " << step;
        }
      }
    }
  }
}

TEST(Radius, what_lies_in_a_plane_away_from_the_edges_has_no_limit) {
  const auto triangles = shapes::gridded_box({0, 0, 0}, {50, 50, 50}, 5);
  const TriangleMesh mesh = shapes::mesh(triangles);
  const Field field = measured(triangles);
  std::size_t inner = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vec3d c = mesh.centroid(field.facets[i]);
    const auto inside = [](double x) { return x < 1e-9 || x > 50 - 1e-9 || (x > 5 && x < 45); };
    if (!inside(c.x) || !inside(c.y) || !inside(c.z)) continue;
    ++inner;
    EXPECT_EQ(field.value[i], infinity);
    EXPECT_GT(field.lower[i], 1000);
  }
  EXPECT_EQ(inner, 6U * 8 * 8 * 2);
}

TEST(Radius, an_edge_is_bounded_by_what_hides_within_the_sag) {
  for (const double degrees : {10.0, 20.0, 26.0, 45.0, 120.0}) {
    const double turn = degrees * pi / 180;
    const Leg long_leg{50, 80};
    const double largest = 0.1 / (1 - std::cos(turn / 2));
    EXPECT_NEAR(largest_rounding(turn, 0.1, long_leg, long_leg), largest, 1e-6 * largest);
    EXPECT_NEAR(most_turn(largest, 0.1, long_leg, long_leg), turn, 1e-9);
  }
  EXPECT_EQ(largest_rounding(0, 0.1, {1, 1}, {1, 1}), infinity);
}

TEST(Radius, an_edge_of_25_deg_is_undecided_at_r4_and_one_of_27_fails) {
  const Field below = measured(roof(25 * pi / 180, 40, 60));
  const Field above = measured(roof(27 * pi / 180, 40, 60));
  EXPECT_GT(*std::min_element(below.upper.begin(), below.upper.end()), 4);
  EXPECT_THAT(below.lower, testing::Each(0));
  EXPECT_LT(*std::min_element(above.upper.begin(), above.upper.end()), 4);
}

TEST(Radius, an_edge_counts_only_when_the_region_selects_it) {
  const TriangleMesh mesh = shapes::mesh(roof(pi / 2, 40, 60));
  Region region = whole_model(mesh);
  region.edges.assign(4, {Selected::no, Selected::no, Selected::no});
  for (const double upper : measured(mesh, 0.1, region).upper) EXPECT_EQ(upper, infinity);
  region.edges[0][1] = Selected::maybe;  // from (0, 0, 0) to (0, 60, 0)
  for (const double upper : measured(mesh, 0.1, region).upper) EXPECT_EQ(upper, infinity);
  EXPECT_EQ(measured(mesh, 0.1, region).lower[0], 0);
  region.edges[0][1] = Selected::yes;
  EXPECT_LT(measured(mesh, 0.1, region).upper[0], 0.4);
  EXPECT_LT(measured(mesh, 0.1, region).upper[3], 0.4) << "the facet across the edge";
}

TEST(Radius, hollows_have_no_limit) {
  auto triangles = shapes::flipped(roof(pi / 2, 40, 60));
  const Field field = measured(triangles);
  EXPECT_THAT(field.upper, testing::Each(infinity));
}

TEST(Radius, a_sphere_reads_its_radius) {
  for (const double radius : {2.0, 10.0, 100.0}) {
    const Field field = measured(shapes::sphere(radius, 40, 80), radius * 0.002);
    expect_bounds(field, radius);
    for (const double value : field.value) EXPECT_NEAR(value, radius, 0.02 * radius);
  }
}

TEST(Radius, a_torus_reads_the_radius_of_its_tube) {
  for (const int segments : {24, 60}) {
    const Field field = measured(shapes::torus(30, 5, 4 * segments, segments));
    expect_bounds(field, 5);
    for (const double value : field.value) EXPECT_NEAR(value, 5, 0.1);
  }
}

TEST(Radius, a_cylinder_reads_its_radius_whatever_its_length) {
  for (const double length : {8.0, 300.0}) {
    const auto circle = shapes::arc({0, 0}, 5, 0, 2 * pi, 32);
    const auto triangles = shapes::extrude({circle.begin(), circle.end() - 1}, 0, length);
    const TriangleMesh mesh = shapes::mesh(triangles);
    Region region = whole_model(mesh);
    region.edges.assign(mesh.facet_count(), {Selected::yes, Selected::yes, Selected::yes});
    for (FacetId f = 0; f < mesh.facet_count(); ++f) {  // not its sharp rims
      for (int e = 0; e < 3; ++e) {
        if (mesh.corner(f, e).z == mesh.corner(f, (e + 1) % 3).z)
          region.edges[f][static_cast<std::size_t>(e)] = Selected::no;
      }
    }
    const Field field = measured(mesh, 0.1, region);
    for (FacetId f = 0; f < 64; ++f) EXPECT_NEAR(field.value[f], 5, 0.1) << "length " << length;
  }
}

TEST(Radius, a_polygon_whose_sides_leave_the_circle_by_more_than_the_sag_has_sharp_edges) {
  const auto corners = shapes::arc({0, 0}, 13, 0, 2 * pi, 8);
  const Field field = measured(shapes::extrude({corners.begin(), corners.end() - 1}, 0, 40));
  for (FacetId f = 0; f < 16; ++f) EXPECT_LT(field.upper[f], 1.4);
}

TEST(Radius, the_two_sides_of_a_thin_plate_are_not_mixed) {
  const auto triangles = shapes::gridded_box({0, 0, 0}, {20, 20, 0.5}, 1);
  const TriangleMesh mesh = shapes::mesh(triangles);
  const Field field = measured(triangles);
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const Vec3d c = mesh.centroid(f);
    if (c.x > 2 && c.x < 18 && c.y > 2 && c.y < 18) {
      EXPECT_EQ(field.value[f], infinity);
    }
  }
}

TEST(Radius, a_narrow_flat_between_two_roundings_does_not_make_them_one) {
  // The edge of a plate of 4 mm: R1, a flat of 2 mm, R1; flat and chords together would pass for R4.7.
  std::vector<shapes::Point2> profile;
  for (const auto& [x, y, from] :
       {std::array{1.0, 1.0, pi}, {39.0, 1.0, 1.5 * pi}, {39.0, 3.0, 0.0}, {1.0, 3.0, pi / 2}}) {
    for (const shapes::Point2& p : shapes::arc({x, y}, 1, from, from + pi / 2, 3)) profile.push_back(p);
  }
  const auto triangles = shapes::extrude(profile, 0, 30, 5);
  const TriangleMesh mesh = shapes::mesh(triangles);
  const Field field = measured(triangles);
  int rounded = 0;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const Vec3d n = facet_normal(mesh, f);
    if (std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}) > 0.999) continue;
    ++rounded;
    EXPECT_LT(field.lower[f], 1.01);
  }
  EXPECT_EQ(rounded, 4 * 3 * 5 * 2);
}

// A plate with rounded edges of five strips each and a flat between them; all strips as long as the plate.
struct Plate {
  TriangleMesh mesh;
  Field field;
};

Plate plate(double radius, double flat) {
  std::vector<shapes::Point2> profile;
  const double low = radius, high = radius + flat, far = 40 - radius;
  for (const auto& [x, y, from] :
       {std::array{radius, low, pi}, {far, low, 1.5 * pi}, {far, high, 0.0}, {radius, high, pi / 2}}) {
    for (const shapes::Point2& p : shapes::arc({x, y}, radius, from, from + pi / 2, 5)) profile.push_back(p);
  }
  const auto triangles = shapes::extrude(profile, 0, 40, 8);
  return {shapes::mesh(triangles), measured(triangles)};
}

TEST(Radius, roundings_beside_a_flat_narrower_than_their_strips_are_decided) {
  const Plate tight = plate(3, 0.55);
  const Plate round = plate(6, 1.1);
  int failed = 0;
  for (FacetId f = 0; f < tight.mesh.facet_count(); ++f) {
    const Vec3d n = facet_normal(tight.mesh, f);
    const double z = tight.mesh.centroid(f).z;
    if (std::fabs(n.z) > 0.5 || z < 10 || z > 30) continue;  // away from the sharp ends
    EXPECT_GT(round.field.lower[f], 4) << "R6, facet " << f;
    if (std::max(std::fabs(n.x), std::fabs(n.y)) > 0.999) {
      EXPECT_EQ(tight.field.upper[f], infinity) << "the flat, facet " << f;
    } else {
      EXPECT_LT(tight.field.lower[f], 3.01) << "facet " << f;
      failed += tight.field.upper[f] < 4;
    }
  }
  EXPECT_GE(failed, 4 * 4 * 2 * 4) << "four strips of five";
}

TEST(Radius, the_sharp_end_of_a_cylinder_is_not_explained_by_its_roundness) {
  for (const double radius : {3.0, 6.0, 13.0}) {
    for (const int layers : {1, 4}) {
      const auto triangles =
          shapes::extrude(shapes::arc({0, 0}, radius, 0, 2 * pi * 39 / 40, 39), 0, 50, layers);
      const TriangleMesh mesh = shapes::mesh(triangles);
      const Field field = measured(triangles);
      int ends = 0;
      for (FacetId f = 0; f < mesh.facet_count(); ++f) {
        if (std::fabs(facet_normal(mesh, f).z) < 0.5) continue;
        ++ends;
        EXPECT_EQ(field.lower[f], 0) << "R" << radius << ", facet " << f;
        EXPECT_LT(field.upper[f], 0.4) << "R" << radius << ", facet " << f;
      }
      EXPECT_EQ(ends, 2 * 38);
    }
  }
}

TEST(Radius, moving_rotating_and_permuting_the_mesh_moves_nothing) {
  const auto meshed =
      fillets::mesh({.radius = 5, .angle = pi / 2, .step = 1.5, .meshing = fillets::Meshing::jittered_flips});
  const Field straight = measured(meshed.triangles, meshed.sag);
  std::vector<std::uint32_t> order;
  const auto moved =
      shapes::moved(shapes::rotated(meshed.triangles, normalized(Vec3d{1, 2, 3}), 0.7), {120, -80, 300});
  const Field other = measured(shapes::permuted(moved, 5, &order), meshed.sag);
  for (std::size_t i = 0; i < other.size(); ++i) {
    const auto near = [&](double a, double b) {
      return (std::isnan(a) && std::isnan(b)) || a == b || std::fabs(a - b) < 2e-3 * std::fabs(b);
    };
    EXPECT_TRUE(near(other.value[i], straight.value[order[i]])) << other.value[i];
    EXPECT_TRUE(near(other.lower[i], straight.lower[order[i]])) << other.lower[i];
    EXPECT_TRUE(near(other.upper[i], straight.upper[order[i]])) << other.upper[i];
  }
}

TEST(Radius, a_few_facets_read_the_same_alone_as_in_the_whole_and_on_any_thread_count) {
  const auto meshed =
      fillets::mesh({.radius = 3, .angle = pi / 2, .step = 0.5, .meshing = fillets::Meshing::unmarked});
  const TriangleMesh mesh = shapes::mesh(meshed.triangles);
  const Field whole = measured(mesh, meshed.sag, whole_model(mesh), 2);
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    Region region;
    region.facets.assign(mesh.facet_count(), Selected::no);
    for (int i = 0; i < 10; ++i) region.facets[random() % mesh.facet_count()] = Selected::yes;
    region.edges.assign(mesh.facet_count(), {Selected::yes, Selected::yes, Selected::yes});
    const Field some = measured(mesh, meshed.sag, region);
    for (std::size_t i = 0; i < some.size(); ++i) {
      const FacetId f = some.facets[i];
      EXPECT_EQ(std::isnan(some.value[i]), std::isnan(whole.value[f]));
      if (!std::isnan(some.value[i])) {
        EXPECT_EQ(some.value[i], whole.value[f]);
      }
      EXPECT_EQ(some.lower[i], whole.lower[f]);
      EXPECT_EQ(some.upper[i], whole.upper[f]);
    }
  }
}

}  // namespace
}  // namespace gabarit
