#include "checks/vertical_cylinder_contact.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/shapes.h"

namespace gabarit {
namespace {

using shapes::box;

struct Case {
  double sag = 0.1;
  Motion motion = Motion::any;
  Frame frame = {};
  Interval band = {};
  int threads = 1;
  ContactMethod method = ContactMethod::exact;
  double spacing = 0.98;
};

Region region_of(const shapes::Triangles& triangles, const Case& c = {}) {
  const Model model = shapes::model(triangles, c.sag);
  const Scene scene(model, Device::cpu(c.threads));
  gabarit::Setup setup;
  setup.frame = c.frame;
  setup.sag = c.sag;
  setup.height_band = c.band;
  return vertical_cylinder_contact(scene, setup,
                                   {.radius = 150,
                                    .motion = c.motion,
                                    .tolerance = std::max(1e-3, c.sag),
                                    .method = c.method,
                                    .spacing = c.spacing});
}

std::vector<Selected> touched(const shapes::Triangles& triangles, const Case& c = {}) {
  return region_of(triangles, c).facets;
}

std::size_t count(const std::vector<Selected>& all, Selected s, std::size_t from = 0,
                  std::size_t to = SIZE_MAX) {
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(to, all.size()));
  return static_cast<std::size_t>(std::count(all.begin() + static_cast<std::ptrdiff_t>(from), end, s));
}

TEST(VerticalCylinderContact, a_box_of_twelve_facets_is_touched_along_its_long_facets) {
  const auto all = touched(box({0, 0, 0}, {2000, 800, 300}));
  EXPECT_EQ(count(all, Selected::yes), 12U);  // the lids too: their rims are touched
}

// Two walls and a floor that leave a pocket open to the front and one to the rear; the floor's facets are the
// last twelve.
shapes::Triangles pocket(double mouth) {
  const double h = mouth / 2;
  return shapes::joined(
      shapes::joined(box({0, h, 0}, {1000, h + 100, 500}), box({0, -h - 100, 0}, {1000, -h, 500})),
      box({450, -h, 0}, {550, h, 500}));
}

TEST(VerticalCylinderContact, mouths_just_under_and_over_the_diameter_are_told_apart_at_a_fine_sag) {
  const auto closed = touched(pocket(299.99), {.sag = 0.001});
  const auto open = touched(pocket(300.01), {.sag = 0.001});
  EXPECT_EQ(count(closed, Selected::no, 24), 12U);
  EXPECT_EQ(count(open, Selected::no, 24), 4U);  // the faces that lie against the walls
  EXPECT_GT(count(open, Selected::yes, 24), 0U);
}

TEST(VerticalCylinderContact, mouths_just_under_and_over_the_diameter_are_both_maybe_at_a_coarse_sag) {
  for (const double mouth : {299.99, 300.01}) {
    const auto all = touched(pocket(mouth), {.sag = 0.1});
    EXPECT_EQ(count(all, Selected::yes, 24), 0U) << mouth;
    EXPECT_GT(count(all, Selected::maybe, 24), 0U) << mouth;
  }
}

TEST(VerticalCylinderContact, ordinary_contacts_stay_certain_at_any_sag) {
  EXPECT_EQ(count(touched(box({0, 0, 0}, {2000, 800, 300}), {.sag = 0.5}), Selected::yes), 12U);
}

TEST(VerticalCylinderContact, a_hole_of_800_mm_is_never_touched) {
  const auto ring = shapes::revolve({{400, 0}, {900, 0}, {900, 300}, {400, 300}, {400, 0}}, 96);
  const auto all = touched(ring);
  const TriangleMesh mesh = shapes::mesh(ring);
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    const Vec3d c = mesh.centroid(f);
    const bool inner_wall = std::hypot(c.x, c.y) < 420 && facet_normal(mesh, f).z == 0;
    const bool outer_wall = std::hypot(c.x, c.y) > 880 && facet_normal(mesh, f).z == 0;
    EXPECT_FALSE(inner_wall && all[f] != Selected::no);
    EXPECT_FALSE(outer_wall && all[f] != Selected::yes);
  }
}

TEST(VerticalCylinderContact, what_stands_above_and_is_wider_shields_what_is_below) {
  const auto shapes =
      shapes::joined(box({0, 0, 0}, {1000, 100, 100}), box({-300, -300, 400}, {1300, 400, 500}));
  EXPECT_EQ(count(touched(shapes), Selected::yes, 0, 12), 0U);
  // With the column only 300 mm high the wide part is out of its band.
  const auto low = touched(shapes, {.band = {0, 300}});
  EXPECT_EQ(count(low, Selected::yes, 0, 12), 12U);
  EXPECT_EQ(count(low, Selected::no, 12, 24), 12U);
}

TEST(VerticalCylinderContact, facets_are_clipped_to_the_band_not_dropped) {
  // A roof that leans outwards over a post: below 100 mm it is narrower than the post.
  const auto leaning = shapes::Triangles{{{{0, -500, 0}, {0, 500, 0}, {-600, 0, 600}}}};
  const auto shapes = shapes::joined(leaning, box({-50, -20, 0}, {50, 20, 90}));
  EXPECT_GT(count(touched(shapes, {.band = {0, 100}}), Selected::yes, 1), 0U);
  EXPECT_EQ(count(touched(shapes), Selected::yes, 0, 1), 1U);
}

TEST(VerticalCylinderContact, forward_motion_drops_what_faces_backwards_and_keeps_the_sides) {
  const auto solid = box({0, 0, 0}, {1000, 400, 300});
  const auto all = touched(solid, {.motion = Motion::forward});
  const TriangleMesh mesh = shapes::mesh(solid);
  for (FacetId f = 0; f < mesh.facet_count(); ++f) {
    EXPECT_EQ(all[f], facet_normal(mesh, f).x > 0.5 ? Selected::no : Selected::yes);
  }
}

TEST(VerticalCylinderContact, a_sweep_misses_what_lies_in_the_lee_of_a_wide_part) {
  // A wide bar in front, a narrow body behind it: right behind the bar a column moving inwards at 45 degrees
  // passes by.
  auto shapes = shapes::joined(box({0, -500, 0}, {50, 500, 300}), box({50, -100, 0}, {1500, 100, 300}));
  shapes = shapes::joined(shapes, box({100, 100, 0}, {140, 130, 300}));    // a knob in the lee
  shapes = shapes::joined(shapes, box({1300, 100, 0}, {1340, 130, 300}));  // and one far behind
  const auto sweep = touched(shapes, {.motion = Motion::sweep});
  EXPECT_EQ(count(sweep, Selected::no, 24, 36), 12U);
  EXPECT_GT(count(sweep, Selected::yes, 36, 48), 0U);
  EXPECT_GT(count(touched(shapes), Selected::yes, 24, 36), 0U);
  // The front of the bar counts as the column jumps outwards along it.
  EXPECT_GT(count(sweep, Selected::yes, 0, 12), 0U);
}

TEST(VerticalCylinderContact, a_sweep_may_cross_the_middle_behind_a_part_of_one_side) {
  // Two posts left of the middle, the second a little further in: a column that passes the first on its inner
  // side meets the front of the second.
  auto shapes = shapes::joined(box({0, -500, 0}, {50, -400, 300}), box({300, -300, 0}, {350, -200, 300}));
  shapes = shapes::joined(shapes, box({2000, 0, 0}, {2050, 500, 300}));
  const auto sweep = touched(shapes, {.motion = Motion::sweep});
  const TriangleMesh mesh = shapes::mesh(shapes);
  for (FacetId f = 12; f < 24; ++f) {
    const bool front = facet_normal(mesh, f).x < -0.5;
    EXPECT_TRUE(!front || sweep[f] == Selected::yes) << f;
  }
}

shapes::Triangles yard() {
  auto all = shapes::joined(pocket(500), box({200, -30, 0}, {230, 0, 400}));
  return shapes::joined(all, shapes::moved(shapes::sphere(80, 24, 48), {-300, 0, 100}));
}

TEST(VerticalCylinderContact, moving_turning_and_shuffling_the_model_turns_the_answer_with_it) {
  const auto expected = touched(yard());
  std::vector<std::uint32_t> order;
  const auto shuffled = touched(shapes::permuted(yard(), 5, &order));
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(shuffled[i], expected[order[i]]) << i;
  const auto turned = shapes::moved(shapes::rotated(yard(), {0, 0, 1}, 0.7), {5000, -3000, 20});
  EXPECT_EQ(touched(turned), expected);
}

TEST(VerticalCylinderContact, the_frame_says_what_is_vertical) {
  const auto expected = touched(yard(), {.motion = Motion::forward});
  // z up, -x forward becomes y up, z forward: x = -z', y = -x', z = y'.
  shapes::Triangles laid = yard();
  for (auto& t : laid) {
    for (Vec3d& p : t) p = {-p.y, p.z, -p.x};
  }
  Frame frame;
  frame.up = {0, 1, 0};
  frame.forward = {0, 0, 1};
  EXPECT_EQ(touched(laid, {.motion = Motion::forward, .frame = frame}), expected);
}

TEST(VerticalCylinderContact, two_threads_find_what_one_finds) {
  EXPECT_EQ(touched(yard(), {.threads = 2}), touched(yard(), {.threads = 1}));
}

TEST(VerticalCylinderContact, an_empty_band_selects_nothing) {
  EXPECT_EQ(count(touched(yard(), {.band = {5000, 6000}}), Selected::no), yard().size());
}

TEST(VerticalCylinderContact, facets_that_are_not_finite_are_left_out) {
  auto shapes = box({0, 0, 0}, {100, 100, 100});
  shapes.push_back({{{0, 0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}, {0, 1, 0}}});
  shapes.push_back({{{0, 0, 0}, {std::numeric_limits<double>::infinity(), 0, 0}, {0, 1, 0}}});
  const auto all = touched(shapes);
  EXPECT_EQ(count(all, Selected::yes), 12U);
}

TEST(VerticalCylinderContact, absurd_coordinates_are_left_out_and_said) {
  auto shapes = box({0, 0, 0}, {100, 100, 100});
  shapes.push_back({{{0, 0, 0}, {1e300, 0, 0}, {0, -1e300, 1e308}}});
  const Region region = region_of(shapes);
  EXPECT_EQ(count(region.facets, Selected::yes), 12U);
  ASSERT_FALSE(region.notes.empty());
  EXPECT_EQ(region.notes[0], "1 facet was left out: coordinates that are not finite or beyond 1000 km.");
}

TEST(VerticalCylinderContact, the_path_around_a_box_is_one_closed_trace) {
  const Region region = region_of(box({0, 0, 50}, {1000, 400, 100}));
  ASSERT_EQ(region.traces.size(), 1U);
  EXPECT_TRUE(region.traces[0].closed);
  double around = 0;
  const auto& points = region.traces[0].points;
  for (std::size_t i = 1; i < points.size(); ++i) around += length(points[i] - points[i - 1]);
  // Chords with a sag of s are shorter than their arcs by a share of s / 3R.
  const double arcs = 300 * std::numbers::pi;
  EXPECT_LE(around, 2800 + arcs);
  EXPECT_GE(around, 2800 + arcs * (1 - 1.05 / (3 * 150)));
  for (const Vec3d& p : points) EXPECT_EQ(p.z, 0.0);
}

TEST(VerticalCylinderContact, the_notes_name_the_places_that_the_sag_decides) {
  const Region region = region_of(pocket(300.01));
  ASSERT_EQ(region.notes.size(), 2U);
  EXPECT_NE(region.notes[1].find("depends on the sag"), std::string::npos);
  const Region none = region_of(pocket(300.01), {.band = {5000, 6000}});
  ASSERT_EQ(none.notes.size(), 1U);
  EXPECT_NE(none.notes[0].find("touches nothing"), std::string::npos);
}

TEST(VerticalCylinderContact, a_model_that_is_huge_for_the_column_stays_within_memory) {
  EXPECT_EQ(count(touched(box({0, 0, 0}, {2e6, 1e6, 300})), Selected::yes), 12U);
}

// Shapes on which the column slides, rolls, bridges and turns around in a yard, at odd angles.
shapes::Triangles parts() {
  auto all = shapes::joined(yard(), shapes::moved(shapes::torus(220, 40, 48, 12), {-900, 200, 50}));
  all = shapes::joined(all, shapes::moved(shapes::rotated(pocket(310), {0, 0, 1}, 0.5), {1500, 900, 0}));
  return shapes::joined(all, shapes::rotated(box({-2000, -900, 0}, {-1200, -640, 100}), {0, 0, 1}, -0.3));
}

TEST(VerticalCylinderContact, what_dexels_decide_the_exact_method_decides_alike) {
  for (const double turn : {0.0, 0.4}) {
    const auto solid = shapes::rotated(parts(), {0, 0, 1}, turn);
    const auto exact = touched(solid);
    for (const double spacing : {0.98, 5.0}) {
      const auto dexel = touched(solid, {.method = ContactMethod::dexel, .spacing = spacing});
      std::size_t decided = 0;
      for (std::size_t f = 0; f < exact.size(); ++f) {
        if (dexel[f] == Selected::maybe) continue;
        ++decided;
        EXPECT_EQ(dexel[f], exact[f]) << "facet " << f << ", spacing " << spacing;
      }
      EXPECT_GT(static_cast<double>(decided), 0.7 * static_cast<double>(exact.size()));
      EXPECT_GT(count(dexel, Selected::yes), count(exact, Selected::yes) / 2);
    }
  }
}

TEST(VerticalCylinderContact, a_mouth_within_the_spacing_of_the_diameter_is_maybe_for_dexels) {
  for (const double mouth : {300.3, 300.9}) {
    EXPECT_GT(count(touched(pocket(mouth)), Selected::yes, 24), 0U) << mouth;
    const auto all = touched(pocket(mouth), {.method = ContactMethod::dexel});
    EXPECT_EQ(count(all, Selected::yes, 24), 0U) << mouth;
    EXPECT_GT(count(all, Selected::maybe, 24), 0U) << mouth;
  }
}

TEST(VerticalCylinderContact, dexels_give_the_same_answer_on_any_number_of_threads) {
  const Region one = region_of(parts(), {.threads = 1, .method = ContactMethod::dexel});
  const Region four = region_of(parts(), {.threads = 4, .method = ContactMethod::dexel});
  EXPECT_EQ(one.facets, four.facets);
  EXPECT_EQ(one.depth, four.depth);
}

TEST(VerticalCylinderContact, dexels_say_what_they_cannot_do) {
  const auto solid = box({0, 0, 0}, {100, 100, 100});
  EXPECT_THROW(region_of(solid, {.motion = Motion::sweep, .method = ContactMethod::dexel}),
               std::invalid_argument);
  EXPECT_THROW(region_of(solid, {.method = ContactMethod::dexel, .spacing = 80}), std::invalid_argument);
  EXPECT_THROW(region_of(solid, {.method = ContactMethod::dexel, .spacing = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace gabarit
