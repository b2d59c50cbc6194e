#include "model/trim_loops.h"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "model/brep_trim.h"
#include "model/monotone_cuts.h"

namespace gabarit {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

// One face on a surface that is R1 where it is round.
Brep on(SurfaceKind kind, ParameterBox range) {
  Surface s;
  s.kind = kind, s.u_periodic = kind != SurfaceKind::plane, s.v_periodic = kind == SurfaceKind::torus;
  s.axes.y = {0, 1, 0}, s.axes.z = {0, 0, 1};
  s.radius = kind == SurfaceKind::torus ? 3 : 1, s.minor = 1;
  s.domain = {s.u_periodic ? 0 : -infinity, s.u_periodic ? 2 * pi : infinity, -infinity, infinity};
  if (kind == SurfaceKind::torus) s.domain.v0 = 0, s.domain.v1 = 2 * pi;
  if (kind == SurfaceKind::sphere) s.domain.v0 = -pi / 2, s.domain.v1 = pi / 2;
  Brep brep;
  brep.surfaces.push_back(s);
  Face face;
  face.surface = 0, face.range = range;
  brep.faces.push_back(face);
  return brep;
}

TrimStretch straight(Parameters from, Parameters to) {
  TrimStretch s;
  s.start = from, s.end = to;
  return s;
}
TrimWire polygon(const std::vector<Parameters>& corners) {
  TrimWire wire;
  for (std::size_t i = 0; i < corners.size(); ++i)
    wire.push_back(straight(corners[i], corners[(i + 1) % corners.size()]));
  return wire;
}
bool inside(const Brep& brep, double u, double v) {
  return trim_side(view(brep), 0, {u, v}) == TrimSide::inside;
}

TEST(TrimLoops, a_face_without_curves_is_its_whole_surface) {
  Brep brep = on(SurfaceKind::sphere, {0, 2 * pi, -pi / 2, pi / 2});
  add_trim({}, brep);
  EXPECT_TRUE(inside(brep, 0, 0));
  EXPECT_TRUE(inside(brep, -77, pi / 2));
  EXPECT_EQ(brep.untrimmed, 0U);
}

TEST(TrimLoops, curves_may_come_in_any_order) {
  const TrimWire sorted = polygon({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
  for (const std::array order : {std::array{0, 1, 2, 3, 4}, {3, 1, 4, 0, 2}, {4, 3, 2, 1, 0}}) {
    Brep brep = on(SurfaceKind::plane, {0, 4, 0, 4});
    TrimWire wire;
    for (const int i : order) wire.push_back(sorted[static_cast<std::size_t>(i)]);
    add_trim({wire}, brep);
    EXPECT_TRUE(inside(brep, 0.5, 2));
    EXPECT_TRUE(inside(brep, 3.5, 2));
    EXPECT_FALSE(inside(brep, 2, 2));
    EXPECT_FALSE(inside(brep, -1, 1));
    EXPECT_EQ(brep.leaky, 0U);
  }
}

TEST(TrimLoops, a_gap_is_closed_and_a_wide_one_is_counted) {
  for (const double gap : {1e-9, 1e-4, 0.1}) {
    Brep brep = on(SurfaceKind::plane, {0, 4, 0, 4});
    TrimWire wire = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    wire[1].end.v -= gap;  // the right side ends too low
    add_trim({wire}, brep);
    EXPECT_EQ(brep.leaky, gap > 1e-3 ? 1U : 0U);
    for (const double off : {-0.5, 0.0, 0.5}) {
      EXPECT_TRUE(inside(brep, 2, 4 - gap + off * gap)) << gap;
      EXPECT_FALSE(inside(brep, -2, 4 - gap + off * gap)) << gap;
    }
  }
}

TEST(TrimLoops, tiny_curves_do_not_let_a_ray_through) {
  Brep brep = on(SurfaceKind::plane, {0, 4, 0, 4});
  add_trim(
      {polygon({{0, 0}, {4, 0}, {4, 2}, {4, 2 + 4e-16}, {4 + 1e-15, 2 + 1e-15}, {4, 4}, {0, 4}, {0, 2}})},
      brep);
  for (const double v : {2.0, 2 + 4e-16, 2 + 9e-16, 2 + 1e-15}) {
    EXPECT_TRUE(inside(brep, 1, v));
    EXPECT_FALSE(inside(brep, -1, v));
    EXPECT_FALSE(inside(brep, 5, v));
  }
}

TEST(TrimLoops, a_ring_of_a_tube_needs_no_seam) {
  Brep brep = on(SurfaceKind::cylinder, {0, 2 * pi, 1, 3});
  add_trim({{straight({0, 1}, {2 * pi, 1})}, {straight({9, 3}, {9 - 2 * pi, 3})}}, brep);
  for (const double u : {-40.0, 0.0, 3.0, 9.0}) {
    EXPECT_TRUE(inside(brep, u, 2));
    EXPECT_FALSE(inside(brep, u, 0.9));
    EXPECT_FALSE(inside(brep, u, 3.1));
  }
}

TEST(TrimLoops, a_cap_of_a_sphere_is_the_one_on_the_left_of_its_rim) {
  for (const bool upper : {true, false}) {
    Brep brep = on(SurfaceKind::sphere, {0, 2 * pi, -pi / 2, pi / 2});
    add_trim({{straight({upper ? 0 : 2 * pi, 0.3}, {upper ? 2 * pi : 0, 0.3})}}, brep);
    EXPECT_EQ(inside(brep, 1, 1.2), upper);
    EXPECT_EQ(inside(brep, 1, pi / 2), upper);
    EXPECT_EQ(inside(brep, 1, 0.2), !upper);
  }
}

TEST(TrimLoops, a_single_loop_around_an_endless_tube_is_no_face) {
  Brep brep = on(SurfaceKind::cylinder, {0, 2 * pi, 1, 3});
  add_trim({{straight({0, 1}, {2 * pi, 1})}}, brep);
  EXPECT_EQ(brep.untrimmed, 1U);
  EXPECT_TRUE(inside(brep, 1, 2));
}

// Either way round: the face is the part of the ring on the left of the curves.
TEST(TrimLoops, parts_of_a_torus_need_no_seams) {
  for (const bool turned : {false, true}) {
    const double up = turned ? -2 * pi : 2 * pi;
    Brep bend = on(SurfaceKind::torus, {0, 2 * pi, 0, 2 * pi});
    add_trim({{straight({1, 0}, {1, -up})}, {straight({2, 5}, {2, 5 + up})}}, bend);
    Brep gutter = on(SurfaceKind::torus, {0, 2 * pi, 0, 2 * pi});
    add_trim({{straight({0, 1}, {up, 1})}, {straight({5, 2}, {5 - up, 2})}}, gutter);
    for (const double turn : {-2 * pi, 0.0, 4 * pi}) {
      for (const double other : {0.0, 3.0, 6.28}) {
        EXPECT_EQ(inside(bend, 1.5 + turn, other), !turned);
        EXPECT_EQ(inside(bend, 2.5 + turn, other), turned);
        EXPECT_EQ(inside(bend, 0.5 + turn, other), turned);
        EXPECT_EQ(inside(gutter, other, 1.5 + turn), !turned);
        EXPECT_EQ(inside(gutter, other, 2.5 + turn), turned);
        EXPECT_EQ(inside(gutter, other, 0.5 + turn), turned);
      }
    }
  }
}

TEST(TrimLoops, a_hole_in_a_ball_without_a_seam_leaves_the_rest) {
  Brep brep = on(SurfaceKind::sphere, {0, 2 * pi, -pi / 2, pi / 2});
  TrimWire clockwise = polygon({{1, 0.2}, {2, 0.2}, {2, -0.2}, {1, -0.2}});
  add_trim({clockwise}, brep);
  EXPECT_FALSE(inside(brep, 1.5, 0));
  EXPECT_TRUE(inside(brep, 3, 0));
  EXPECT_TRUE(inside(brep, 1.5, 1));
}

// One circle in the plane of parameters, round about (1, 0).
TrimWire circle(double radius, bool clockwise, Brep& brep) {
  Curve c;
  c.kind = CurveKind::circle, c.periodic = true, c.radius = radius, c.last = 2 * pi;
  c.axes.origin = {1, 0, 0}, c.axes.x = {1, 0, 0}, c.axes.y = {0, 1, 0};
  brep.curves.push_back(c);
  TrimStretch s = straight({1 + radius, 0}, {1 + radius, 0});
  s.curve = static_cast<std::uint32_t>(brep.curves.size() - 1), s.last = 2 * pi;
  if (clockwise) std::swap(s.first, s.last);
  return {s};
}

TEST(TrimLoops, a_ring_on_a_ball_lies_between_its_circles_and_not_around_them) {
  for (const bool hole_first : {true, false}) {
    Brep brep = on(SurfaceKind::sphere, {0, 2, -1, 1});
    TrimWire outer = circle(1, false, brep), inner = circle(0.4, true, brep);
    if (hole_first) std::swap(outer, inner);
    add_trim({outer, inner}, brep);
    EXPECT_TRUE(inside(brep, 1.7, 0));
    EXPECT_TRUE(inside(brep, 1, -0.7));
    EXPECT_FALSE(inside(brep, 1, 0));
    EXPECT_FALSE(inside(brep, 2.1, 0));
    EXPECT_FALSE(inside(brep, 4, 1));
  }
}

TEST(TrimLoops, a_hole_may_lie_in_another_turn_than_its_face) {
  Brep brep = on(SurfaceKind::cylinder, {0, 2 * pi, 0, 4});
  add_trim({polygon({{0.5, 0}, {3, 0}, {3, 4}, {0.5, 4}}),
            polygon({{1 - 2 * pi, 1}, {1 - 2 * pi, 2}, {2 - 2 * pi, 2}, {2 - 2 * pi, 1}})},
           brep);
  EXPECT_FALSE(inside(brep, 1.5, 1.5));
  EXPECT_FALSE(inside(brep, 1.5 - 2 * pi, 1.5));
  EXPECT_TRUE(inside(brep, 2.5, 1.5));
  EXPECT_TRUE(inside(brep, 1.5, 3));
  EXPECT_FALSE(inside(brep, 4, 1.5));
}

TEST(TrimLoops, many_pieces_are_found_as_few_are) {
  constexpr int teeth = 3000;
  std::vector<Parameters> corners{{-9, teeth}, {-9, 0}};
  for (int i = 0; i < teeth; ++i) corners.push_back({i % 2 == 0 ? 1.0 : 2.0, 1.0 * i});
  Brep brep = on(SurfaceKind::plane, {-9, 2, 0, teeth});
  add_trim({polygon(corners)}, brep);
  EXPECT_GT(brep.trims[0].bin_count, 1000U);
  EXPECT_LE(brep.trim_listing.size(), 4U * teeth + 16);
  for (int i = 0; i + 1 < teeth; ++i) {
    for (const double part : {0.0, 0.25, 0.75}) {
      const double edge = 1 + (i % 2 == 0 ? part : 1 - part);
      EXPECT_TRUE(inside(brep, edge - 1e-9, i + part));
      EXPECT_FALSE(inside(brep, edge + 1e-9, i + part));
    }
  }
}

TEST(TrimLoops, numbers_that_are_none_leave_the_face_whole_and_counted) {
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    Brep brep = on(SurfaceKind::torus, {0, 2 * pi, 0, 2 * pi});
    add_trim({polygon({{0, 0}, {1, 0}, {1, bad}})}, brep);
    EXPECT_EQ(brep.untrimmed, 1U) << bad;
    EXPECT_TRUE(brep.trim_pieces.empty());
    EXPECT_TRUE(inside(brep, 5, 5));
  }
}

// From 0 on.
Curve spline(double last, int degree, int poles) {
  Curve c;
  c.kind = CurveKind::spline, c.last = last, c.degree = degree, c.pole_count = poles;
  return c;
}

// u always rises, although the poles of its slope change their sign; v rises and falls.
TEST(MonotoneCuts, a_curve_is_cut_where_it_turns_back_and_nowhere_else) {
  Brep brep;
  const Curve c = spline(2, 3, 4);
  brep.knots = {0, 0, 0, 0, 2, 2, 2, 2};
  brep.poles = {{-1, 0, 0, 1}, {0.5, 4, 0, 1}, {-0.5, 4, 0, 1}, {1, 0, 0, 1}};
  const std::vector<double> cuts = monotone_cuts(brep, c, 0, 2);
  ASSERT_EQ(cuts.size(), 1U);
  EXPECT_NEAR(cuts[0], 1, 1e-9);
}

TEST(MonotoneCuts, a_circle_is_cut_at_its_four_ends_in_every_turn) {
  Curve c;
  c.kind = CurveKind::circle, c.periodic = true, c.radius = 3, c.last = 2 * pi;
  c.axes.x = {1, 0, 0}, c.axes.y = {0, 1, 0};
  const std::vector<double> cuts = monotone_cuts({}, c, 0.1, 0.1 + 4 * pi);
  ASSERT_EQ(cuts.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(cuts[i], pi / 2 * (static_cast<double>(i) + 1), 1e-12);
}

TEST(MonotoneCuts, a_level_stretch_with_rounding_in_it_is_one_piece) {
  Brep brep;
  const Curve c = spline(1, 3, 4);
  brep.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  brep.poles = {{0, 7, 0, 1}, {1, 7 + 8.9e-16, 0, 1}, {2, 7 - 8.9e-16, 0, 1}, {3, 7, 0, 1}};
  EXPECT_TRUE(monotone_cuts(brep, c, 0, 1).empty());
}

// A knot that counts as often as the degree lets the curve turn at once; its slope has no root there.
TEST(MonotoneCuts, a_kink_is_a_cut) {
  Brep brep;
  const Curve c = spline(2, 1, 3);
  brep.knots = {0, 0, 1, 2, 2};
  brep.poles = {{0, 0, 0, 1}, {1, 1, 0, 1}, {2, 0, 0, 1}};
  EXPECT_EQ(monotone_cuts(brep, c, 0, 2), std::vector<double>{1});
}

}  // namespace
}  // namespace gabarit
