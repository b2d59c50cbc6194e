// The thickness of meshes that are not what they should be.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/checks/wall_fields.h"

namespace gabarit {
namespace {

using shapes::Point2;
using shapes::Triangles;

TEST(Thickness, an_open_sheet_is_undecided) {
  const Triangles sheet{{Vec3d{0, 0, 0}, Vec3d{10, 0, 0}, Vec3d{0, 10, 0}}};
  const Field field = thickness(sheet);
  EXPECT_EQ(field.absence[0], Absence::open);
  EXPECT_TRUE(std::isnan(field.value[0]));
  EXPECT_EQ(field.lower[0], 0);
  EXPECT_EQ(field.upper[0], INFINITY);
}

TEST(Thickness, a_body_that_is_inside_out_is_undecided) {
  const Field field = thickness(shapes::flipped(shapes::gridded_box({0, 0, 0}, {9, 7, 5}, 3)), at_least(1));
  for (const Absence absence : field.absence) EXPECT_EQ(absence, Absence::open);
}

TEST(Thickness, facets_opposite_a_gap_are_undecided_not_thick) {
  auto plate = shapes::gridded_box({0, 0, 0}, {20, 20, 2}, 2);
  const Triangles whole = plate;
  std::erase_if(plate, [](const shapes::Triangle& t) {
    const Vec3d c = (t[0] + t[1] + t[2]) / 3.0;
    return c.z == 2 && std::fabs(c.x - 10) < 2.1 && std::fabs(c.y - 10) < 2.1;
  });
  ASSERT_LT(plate.size(), whole.size());
  const Field field = thickness(plate);
  std::size_t open = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (field.absence[i] == Absence::open) ++open;
    const bool below =
        field.at[i].z == 0 && std::fabs(field.at[i].x - 10) < 2 && std::fabs(field.at[i].y - 10) < 2;
    if (below) {
      EXPECT_EQ(field.absence[i], Absence::open);
    }
  }
  EXPECT_EQ(open, 8U);
}

TEST(Thickness, a_flipped_facet_and_what_faces_it_are_undecided) {
  auto plate = shapes::gridded_box({0, 0, 0}, {20, 20, 2}, 4);
  std::size_t turned = 0;
  while (!(plate[turned][0].z == 2 && plate[turned][1].z == 2 && plate[turned][2].z == 2)) ++turned;
  std::swap(plate[turned][1], plate[turned][2]);
  const Field field = thickness(plate);
  EXPECT_EQ(field.absence[turned], Absence::open);
  EXPECT_EQ(std::count(field.absence.begin(), field.absence.end(), Absence::open), 2);
}

TEST(Thickness, duplicates_and_degenerate_facets_change_nothing) {
  auto plate = shapes::gridded_box({0, 0, 0}, {20, 20, 2}, 4);
  const std::size_t count = plate.size();
  const Field before = thickness(plate);
  for (std::size_t i = 0; i < count; i += 2) plate.push_back(plate[i]);
  plate.push_back({Vec3d{0, 0, 0}, Vec3d{4, 0, 0}, Vec3d{8, 0, 0}});
  const Field field = thickness(plate);
  for (std::size_t i = 0; i < count; ++i) {
    if (field.absence[i] == Absence::none) {
      EXPECT_NEAR(field.value[i], before.value[i], 1e-9);
    }
  }
  EXPECT_EQ(field.absence.back(), Absence::degenerate);
  EXPECT_TRUE(std::isnan(field.value.back()));
}

// Two plates of 5 mm that overlap by 0.01 mm, the upper one smaller.
Triangles overlapping_plates(double overlap) {
  return shapes::joined(shapes::gridded_box({0, 0, 0}, {20, 20, 5}, 4),
                        shapes::gridded_box({4, 4, 5 - overlap}, {16, 16, 10}, 4));
}

TEST(Thickness, where_a_mesh_overlaps_itself_the_overlap_is_no_wall) {
  const Triangles plates = overlapping_plates(0.01);
  const Field field = thickness(plates, at_least(6));
  std::size_t buried = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vec3d c = shapes::mesh(plates).centroid(field.facets[i]);
    const bool inside = c.z > 4.98 && c.z < 5.005 && std::fabs(c.x - 10) < 5.9 && std::fabs(c.y - 10) < 5.9;
    EXPECT_EQ(field.absence[i], inside ? Absence::buried : Absence::none) << field.facets[i];
    if (inside) {
      ++buried;
      EXPECT_TRUE(std::isnan(field.value[i]));
      EXPECT_EQ(field.upper[i], INFINITY);
    } else {
      EXPECT_GT(field.value[i], 4.9) << field.facets[i];
    }
  }
  EXPECT_EQ(buried, 36U) << "the end of the one plate and what it covers of the other";
  EXPECT_THAT(field.notes, testing::Contains(testing::HasSubstr("The mesh overlaps itself: ")));
}

TEST(Thickness, bodies_that_touch_without_overlap_are_measured_each) {
  const Field field = thickness(overlapping_plates(0), at_least(6));
  EXPECT_EQ(std::count(field.absence.begin(), field.absence.end(), Absence::none),
            static_cast<std::ptrdiff_t>(field.size()));
  EXPECT_NEAR(least_value(field), 5, 1e-9);
}

TEST(Thickness, what_is_buried_and_thick_enough_passes_as_before) {
  const Triangles bars = shapes::joined(shapes::gridded_box({0, 0, 0}, {40, 6, 6}, 3),
                                        shapes::gridded_box({17, -20, 1}, {22, 20, 5}, 3));
  EXPECT_TRUE(passes(thickness(bars, at_least(3.9)), 3.9));
}

// A block with a chamfer of 0.02 mm, which bends from the upper side by 35 degrees: the smooth normals of it
// are those of the upper side. In front of it a strip whose lower side the ball must not see.
TEST(Thickness, the_normals_of_neighbours_do_not_send_a_ball_through_the_facet) {
  const auto block = prism({{0, 0}, {20, 0}, {20, 7.986}, {19.98, 8}, {0, 8}}, 10);
  const auto strip = prism({{20.09, 7.95}, {20.3, 7.95}, {20.3, 7.96}, {20.09, 7.96}}, 10);
  const auto both = shapes::joined(block, strip);
  const Field field = thickness(both);
  const TriangleMesh mesh = shapes::mesh(both);
  std::size_t chamfer = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Vec3d c = mesh.centroid(field.facets[i]);
    if (!(c.x > 19.98 && c.x < 20 && c.y > 7.98 && c.z > 0 && c.z < 10)) continue;
    ++chamfer;
    EXPECT_GT(field.value[i], 5);
  }
  EXPECT_EQ(chamfer, 2U);
}

}  // namespace
}  // namespace gabarit
