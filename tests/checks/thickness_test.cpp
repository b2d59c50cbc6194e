#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/block_solid.h"
#include "tests/checks/wall_fields.h"
#include "tests/shrinking_sphere.h"

namespace gabarit {
namespace {

using shapes::Point2;
using shapes::Triangles;

TEST(Thickness, sound_bodies_with_sharp_edges_pass_at_every_step) {
  for (const double step : {0.2, 0.7, 2.0, 10.0}) {
    const double size = step < 0.5 ? 0.2 : 1;  // not too many facets
    const auto wall = [&](const Triangles& shape, double limit) {
      EXPECT_GE(least_lower(thickness(shape, at_least(limit))), limit * (1 - 1e-9)) << step;
    };
    wall(shapes::gridded_box({0, 0, 0}, Vec3d{12, 9, 7} * size, step), 7 * size);
    wall(shapes::gridded_box({0, 0, 0}, Vec3d{20, 15, 2} * size, step), 2 * size);
    wall(l_bracket(3, std::max(0.7, step)), 3);
  }
  for (const char* step : {"0.2 mm", "0.5 mm", "1 mm", "2 mm", "5 mm", "10 mm"}) {
    const Wanted wanted{.parameters = {{"step", step}}};
    EXPECT_TRUE(passes(thickness(shapes::box({0, 0, 0}, {12, 9, 7}), wanted), 7)) << step;
    EXPECT_TRUE(passes(thickness(shapes::box({0, 0, 0}, {20, 15, 2}), wanted), 2)) << step;
    EXPECT_TRUE(passes(thickness(l_bracket(3, 100), wanted), 3 * (1 - 1e-9))) << step;
  }
}

TEST(Thickness, a_feather_edge_of_30_degrees_is_found) {
  const double angle = std::numbers::pi / 6;
  const auto wedge = prism({{0, 0}, {30 * std::cos(angle), -30 * std::sin(angle)}, {30, 0}}, 10);
  EXPECT_TRUE(fails(thickness(wedge), 1));
  EXPECT_TRUE(fails(thickness(wedge, at_least(1)), 1));
  const auto blunt = prism({{0, 0}, {30, 0}, {37.28, 20}, {7.28, 20}}, 40);
  EXPECT_TRUE(passes(thickness(blunt), 19.9)) << "edges of 70 degrees are none";
}

TEST(Thickness, the_tip_of_a_slender_groove_is_found_on_facets_of_any_size) {
  const Field field = thickness(grooved(1.5));
  EXPECT_TRUE(fails(field, 1.6));
  EXPECT_TRUE(fails(thickness(grooved(1.5), at_least(1.6)), 1.6));
  EXPECT_TRUE(passes(thickness(grooved(1.5), at_least(1.4)), 1.4));
  EXPECT_GE(least_lower(field), 1.5 * (1 - 1e-6));
  const auto thinnest = std::min_element(field.value.begin(), field.value.end()) - field.value.begin();
  EXPECT_NEAR(field.value[static_cast<std::size_t>(thinnest)], 1.5, 0.02);
  EXPECT_NEAR(field.at[static_cast<std::size_t>(thinnest)].x, 20, 0.5) << "opposite the tip";
  EXPECT_NEAR(length(field.contact[static_cast<std::size_t>(thinnest)] -
                     Vec3d{20, 1.5, field.at[static_cast<std::size_t>(thinnest)].z}),
              0, 1e-9);
}

TEST(Thickness, a_tapered_plate_of_twelve_facets_is_thin_at_its_thin_end) {
  const auto plate = tapered_plate();
  ASSERT_EQ(plate.size(), 12U);
  const Field field = thickness(plate);
  EXPECT_TRUE(fails(field, 3));
  EXPECT_TRUE(passes(field, 1.5));
  EXPECT_TRUE(fails(thickness(plate, at_least(3)), 3));
  EXPECT_TRUE(passes(thickness(plate, at_least(1.5)), 1.5));
}

TEST(Thickness, a_limit_from_above_sees_the_thick_end) {
  const auto plate = tapered_plate();
  const Field field = thickness(plate, {.extreme = Extreme::greatest});
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (std::fabs(field.at[i].y) > 1e-9) continue;
    EXPECT_GT(field.lower[i], 11) << "both facets of the lower side reach the thick end";
    EXPECT_LT(field.upper[i], 13);
  }
}

TEST(Thickness, moved_rotated_and_permuted_it_stays_the_same) {
  const auto shape = l_bracket(3, 4);
  const Field as_is = thickness(shape);
  const Field moved = thickness(shapes::moved(shape, {1000.5, -2000.25, 300}));
  const Field turned = thickness(shapes::rotated(shape, normalized(Vec3d{1, 2, 3}), 0.7));
  std::vector<std::uint32_t> order;
  const Field mixed = thickness(shapes::permuted(shape, 5, &order));
  for (std::size_t i = 0; i < as_is.size(); ++i) {
    EXPECT_NEAR(moved.value[i], as_is.value[i], 1e-7 * as_is.value[i]);
    EXPECT_NEAR(turned.value[i], as_is.value[i], 2e-3 * as_is.value[i]) << "cells may be cut otherwise";
    EXPECT_NEAR(mixed.value[i], as_is.value[order[i]], 1e-7 * mixed.value[i]);
  }
}

TEST(Thickness, every_set_of_vector_instructions_and_any_number_of_threads_give_the_same_bits) {
  const auto model = shapes::model(shapes::joined(shapes::torus(20, 5, 24, 12), l_bracket(3, 4)));
  Device portable = Device::cpu(1);
  portable.vectors = VectorSet::portable;
  const Field reference = measure(thickness_measure, model, {.device = portable});
  for (const VectorSet set : {VectorSet::avx2, VectorSet::avx512}) {
    Device device = Device::cpu(3);
    device.vectors = set;
    const Field field = measure(thickness_measure, model, {.device = device});
    EXPECT_EQ(field.value, reference.value);
    EXPECT_EQ(field.lower, reference.lower);
    EXPECT_EQ(field.upper, reference.upper);
    EXPECT_EQ(field.contact, reference.contact);
  }
}

TEST(Thickness, with_facet_normals_and_no_separation_it_is_what_the_paper_computes) {
  const TriangleMesh mesh = shapes::with_facets(shapes::cup_with_a_handle(), 3000);
  Model model;
  model.mesh = mesh;
  model.box = bounding_box(mesh);
  const Field field = measure(
      thickness_measure, model,
      {.parameters = {{"method", "sphere"}, {"separation", "0 deg"}, {"normals", "facet"}, {"step", "1 m"}}});
  std::vector<Primitive> facets;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) facets.push_back({mesh.facets[f], f, {0, 0, 1}, 0});
  const ShrinkingSphere paper(mesh.vertices, facets, 1);
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const double shrunk = 2 * paper.shrink(mesh.centroid(f), -facet_normal(mesh, f), f).radius;
    EXPECT_NEAR(field.value[f], shrunk, 2e-6 * length(model.box.extent())) << f;
  }
}

TEST(Thickness, a_ray_measures_along_the_normal) {
  const auto wedge = tapered_plate();
  const Field field = thickness(wedge, {.parameters = {{"method", "ray"}, {"step", "5 mm"}}});
  EXPECT_NEAR(least_value(field), 2, 0.5);
  const auto plate = shapes::gridded_box({0, 0, 0}, {20, 20, 2}, 4);
  const double longest = 2 / std::cos(10 * std::numbers::pi / 180);
  for (const char* which : {"mean", "shortest"}) {
    const Field cone = thickness(
        plate,
        {.parameters = {{"method", "ray"}, {"cone", "10 deg"}, {"cone value", which}, {"step", "1 m"}}});
    for (std::size_t i = 0; i < cone.size(); ++i) {
      if (std::fabs(cone.at[i].x - 10) > 8 || std::fabs(cone.at[i].y - 10) > 8) continue;
      EXPECT_NEAR(cone.value[i], 2 + (which == std::string("mean") ? (longest - 2) / 2 : 0), 2e-3);
    }
  }
  EXPECT_ANY_THROW(thickness(plate, {.parameters = {{"cone", "10 deg"}}}));
}

TEST(Thickness, a_greatest_value_of_interest_is_what_thicker_places_read) {
  const Field field = thickness(shapes::box({0, 0, 0}, {40, 30, 2}), {.parameters = {{"greatest", "5 mm"}}});
  for (std::size_t i = 0; i < field.size(); ++i) {
    EXPECT_TRUE(field.value[i] == 5 || field.value[i] == 2) << field.value[i];
    EXPECT_EQ(field.upper[i], field.value[i] == 5 ? INFINITY : 2.0);
    EXPECT_GE(field.lower[i], field.value[i] * (1 - 1e-9));
  }
}

}  // namespace
}  // namespace gabarit
