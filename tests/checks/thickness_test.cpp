#include "checks/thickness.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checks/clearance.h"
#include "rules/read_value.h"
#include "tests/block_solid.h"
#include "tests/shapes.h"
#include "tests/shrinking_sphere.h"

namespace gabarit {
namespace {

using shapes::Point2;
using shapes::Triangles;

struct Wanted {
  std::map<std::string, std::string> parameters = {};
  double sag = 0.1;
  Extreme extreme = Extreme::smallest;
  double resolution = 0;
  Device device = Device::cpu(1);
};

Field measure(const Measure& measure, const Model& model, const Wanted& wanted = {}) {
  Arguments arguments;
  for (const Parameter& parameter : measure.parameters) {
    const auto given = wanted.parameters.find(parameter.name);
    if (given != wanted.parameters.end())
      arguments.set(parameter.name, *read_value(parameter, given->second));
  }
  fill_defaults(measure.parameters, arguments);
  Setup setup;
  setup.sag = wanted.sag;
  setup.extreme = wanted.extreme;
  setup.resolution = wanted.resolution;
  return measure.measure(Scene(model, wanted.device), setup, whole_model(model.mesh), arguments);
}

Field thickness(const Triangles& shape, const Wanted& wanted = {}) {
  return measure(thickness_measure, shapes::model(shape, wanted.sag), wanted);
}

double least_lower(const Field& field) { return *std::min_element(field.lower.begin(), field.lower.end()); }
double least_upper(const Field& field) { return *std::min_element(field.upper.begin(), field.upper.end()); }
double least_value(const Field& field) { return *std::min_element(field.value.begin(), field.value.end()); }
bool passes(const Field& field, double limit) { return least_lower(field) >= limit; }
bool fails(const Field& field, double limit) { return least_upper(field) < limit; }

// Every facet's bounds hold the truth, and the value of 99 % of the facets is near it.
void expect_truth(const Triangles& shape, const Field& field,
                  const std::function<double(const Vec3d&)>& truth, double relative) {
  std::size_t near = 0, counted = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const shapes::Triangle& t = shape[field.facets[i]];
    const double t_true = truth((t[0] + t[1] + t[2]) / 3.0);
    if (std::isnan(t_true)) continue;
    ++counted;
    EXPECT_LE(field.lower[i], t_true * (1 + 1e-9))
        << "facet " << field.facets[i] << " value " << field.value[i];
    EXPECT_GE(field.upper[i], t_true * (1 - 1e-9))
        << "facet " << field.facets[i] << " value " << field.value[i];
    if (std::fabs(field.value[i] - t_true) <= relative * t_true) ++near;
  }
  EXPECT_GT(counted, 0U);
  EXPECT_GE(static_cast<double>(near), 0.99 * static_cast<double>(counted));
}

Triangles l_bracket(double wall, double step) {
  shapes::BlockSolid solid;
  solid.lines = {{{0, wall, 30}, {0, 20}, {0, wall, 40}}};
  solid.filled = [](int i, int, int k) { return i == 0 || k == 0; };
  const TriangleMesh mesh = shapes::surface(solid, step);
  Triangles out;
  for (FacetId f = 0; f < mesh.facet_count(); ++f) out.push_back(mesh.corners(f));
  return out;
}

Triangles prism(const std::vector<Point2>& polygon, double length) {
  return shapes::extrude(polygon, 0, length);
}

TEST(Thickness, a_plate_of_2_mm_measures_2_mm) {
  for (const double step : {100.0, 7.0, 1.5}) {
    const Field field = thickness(shapes::gridded_box({0, 0, 0}, {40, 30, 2}, step));
    for (std::size_t i = 0; i < field.size(); ++i) {
      const bool side = field.at[i].z > 1e-9 && field.at[i].z < 2 - 1e-9;
      const double truth = !side ? 2 : std::fabs(field.at[i].x - 20) > 19.9 ? 40 : 30;
      EXPECT_NEAR(field.value[i], truth, 1e-12);
      EXPECT_NEAR(field.lower[i], truth, 1e-5 * truth);
      EXPECT_NEAR(field.upper[i], truth, 1e-12);
    }
  }
}

TEST(Thickness, sound_bodies_with_sharp_edges_pass_at_every_step) {
  for (const double step : {0.7, 2.0, 10.0}) {
    EXPECT_TRUE(passes(thickness(shapes::gridded_box({0, 0, 0}, {12, 9, 7}, step)), 7)) << step;
    EXPECT_TRUE(passes(thickness(shapes::gridded_box({0, 0, 0}, {20, 15, 2}, step)), 2)) << step;
    EXPECT_GE(least_lower(thickness(l_bracket(3, step))), 3 * (1 - 1e-9)) << step;
  }
  for (const char* step : {"0.2 mm", "1 mm", "10 mm"}) {
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
  const auto blunt = prism({{0, 0}, {30, 0}, {37.28, 20}, {7.28, 20}}, 40);
  EXPECT_TRUE(passes(thickness(blunt), 19.9)) << "edges of 70 degrees are none";
}

// A block of 10 mm with a groove of 10 degrees from above whose tip leaves `web`.
Triangles grooved(double web) {
  const double half = (10 - web) * std::tan(5 * std::numbers::pi / 180);
  const std::vector<Point2> outline{{0, 0},    {40, 0},         {40, 10}, {20 + half, 10},
                                    {20, web}, {20 - half, 10}, {0, 10}};
  Triangles out;
  const auto at = [&](std::size_t i, double z) {
    const Point2 p = outline[i % outline.size()];
    return Vec3d{p.x, p.y, z};
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    out.push_back({at(i, 0), at(i + 1, 0), at(i + 1, 25)});
    out.push_back({at(i, 0), at(i + 1, 25), at(i, 25)});
  }
  for (const auto& [i, j, k] :
       std::vector<std::array<std::size_t, 3>>{{0, 1, 4}, {1, 2, 3}, {1, 3, 4}, {0, 4, 5}, {0, 5, 6}}) {
    out.push_back({at(i, 25), at(j, 25), at(k, 25)});
    out.push_back({at(k, 0), at(j, 0), at(i, 0)});
  }
  return out;
}

TEST(Thickness, the_tip_of_a_slender_groove_is_found_on_facets_of_any_size) {
  const Field field = thickness(grooved(1.5));
  EXPECT_TRUE(fails(field, 1.6));
  EXPECT_GE(least_lower(field), 1.5 * (1 - 1e-6));
  const auto thinnest = std::min_element(field.value.begin(), field.value.end()) - field.value.begin();
  EXPECT_NEAR(field.value[static_cast<std::size_t>(thinnest)], 1.5, 0.02);
  EXPECT_NEAR(field.at[static_cast<std::size_t>(thinnest)].x, 20, 0.5) << "opposite the tip";
  EXPECT_NEAR(length(field.contact[static_cast<std::size_t>(thinnest)] -
                     Vec3d{20, 1.5, field.at[static_cast<std::size_t>(thinnest)].z}),
              0, 1e-9);
}

TEST(Thickness, a_tapered_plate_of_twelve_facets_is_thin_at_its_thin_end) {
  const auto plate = prism({{0, 0}, {100, 0}, {100, 12}, {0, 2}}, 60);
  ASSERT_EQ(plate.size(), 12U);
  const Field field = thickness(plate);
  EXPECT_TRUE(fails(field, 3));
  EXPECT_TRUE(passes(field, 1.5));
}

TEST(Thickness, a_limit_from_above_sees_the_thick_end) {
  const auto plate = prism({{0, 0}, {100, 0}, {100, 12}, {0, 2}}, 60);
  const Field field = thickness(plate, {.extreme = Extreme::greatest});
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (std::fabs(field.at[i].y) > 1e-9) continue;
    EXPECT_GT(field.lower[i], 11) << "both facets of the lower side reach the thick end";
    EXPECT_LT(field.upper[i], 13);
  }
}

TEST(Thickness, a_tube_measures_its_wall) {
  for (const int segments : {36, 90}) {
    std::vector<Point2> profile{{8, 0}, {10, 0}, {10, 6}, {8, 6}, {8, 0}};
    const auto tube = shapes::revolve(profile, segments);
    const Field field = thickness(tube);
    expect_truth(
        tube, field, [&](const Vec3d& p) { return p.z < 0.1 || p.z > 5.9 ? NAN : 2.0; },
        segments > 40 ? 0.01 : 0.02);
  }
}

TEST(Thickness, a_ball_a_rod_and_a_torus_measure_their_diameters) {
  const auto ball = shapes::sphere(10, 40, 80);
  expect_truth(
      ball, thickness(ball), [](const Vec3d&) { return 20.0; }, 0.011);
  const auto rod = shapes::revolve({{0, 0}, {5, 0}, {5, 20}, {0, 20}}, 72);
  expect_truth(
      rod, thickness(rod), [](const Vec3d& p) { return p.z < 0.1 || p.z > 19.9 ? 20.0 : 10.0; }, 0.01);
  const auto torus = shapes::torus(30, 4, 120, 40);
  expect_truth(
      torus, thickness(torus), [](const Vec3d&) { return 8.0; }, 0.011);
}

TEST(Thickness, a_shell_measures_its_wall) {
  const auto shell = shapes::joined(shapes::sphere(10, 40, 80), shapes::flipped(shapes::sphere(9, 40, 80)));
  expect_truth(
      shell, thickness(shell), [](const Vec3d&) { return 1.0; }, 0.03);
}

TEST(Thickness, half_a_millimetre_on_a_metre_far_from_the_origin) {
  const Vec3d far{52000, -31000, 8000};
  const auto plate = shapes::gridded_box(far, far + Vec3d{1000, 700, 0.5}, 50);
  const Field field = thickness(plate);
  EXPECT_NEAR(least_value(field), 0.5, 1e-9);
  EXPECT_GT(least_lower(field), 0.4999);
}

TEST(Thickness, clearance_is_the_width_of_a_slot) {
  const auto blocks = shapes::joined(shapes::gridded_box({0, 0, 0}, {20, 20, 10}, 5),
                                     shapes::gridded_box({0, 0, 10.6}, {20, 20, 20}, 5));
  const Field field = measure(clearance_measure, shapes::model(blocks));
  for (std::size_t i = 0; i < field.size(); ++i) {
    const bool slot =
        std::fabs(field.at[i].z - 10.3) < 0.31 && (field.at[i].z == 10 || field.at[i].z == 10.6);
    if (slot) {
      EXPECT_NEAR(field.value[i], 0.6, 1e-9);
    } else {
      EXPECT_EQ(field.value[i], INFINITY);
      EXPECT_GE(field.lower[i], 20) << "a limit from below is passed";
    }
    EXPECT_EQ(field.absence[i], Absence::none);
  }
}

TEST(Thickness, an_open_sheet_is_undecided) {
  const Triangles sheet{{Vec3d{0, 0, 0}, Vec3d{10, 0, 0}, Vec3d{0, 10, 0}}};
  const Field field = thickness(sheet);
  EXPECT_EQ(field.absence[0], Absence::open);
  EXPECT_TRUE(std::isnan(field.value[0]));
  EXPECT_EQ(field.lower[0], 0);
  EXPECT_EQ(field.upper[0], INFINITY);
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
  const auto wedge = prism({{0, 0}, {100, 0}, {100, 12}, {0, 2}}, 60);
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
